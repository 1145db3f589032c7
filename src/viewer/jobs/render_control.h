#pragma once
#include <oneapi/tbb/global_control.h>
#include <rayscope/render_session.h>
#include <chrono>
#include <memory>
#include <optional>

#include "measure/target/error_monitor.h"
#include "viewer/jobs/background_job.h"
#include "viewer/model/edit_state.h"

namespace rayscope::viewer {

/// When to stop tracing a picture, besides at its number of samples.
struct StopCriteria {
    bool byError = false;  ///< when the error is below `error`, whatever the number of samples
    float error = 0.005f;  ///< root mean squared error of linear values
    float confidence = 0.95f;
    bool byTime = false;  ///< after `seconds` of tracing
    float seconds = 30.0f;
    bool operator==(const StopCriteria&) const = default;
};

/// Decides what the session renders: of each new view first a preview with as few pixels as it takes to be
/// whole within a tenth of a second, then the current state at full size; one sample per pixel while the
/// rasterised view is shown, which keeps the world compiled for debug rays.
class RenderControl {
  public:
    /// Samples per pixel, at most, of a picture that stops at an error target.
    static constexpr int kMaxSamples = 1 << 16;

    /// `threads` 0 traces on all cores, but leaves one to the window while something moves.
    explicit RenderControl(int threads);

    struct ViewRequest {
        EditState state;
        int width = 1, height = 1;
        bool moving = false;  ///< the camera or a light is being dragged
        bool traced = false;  ///< the ray-traced view is shown
        StopCriteria stopCriteria;
    };
    /// Submits the render that the request needs, unless it is the current one. To be called in each frame.
    void update(const ViewRequest& viewRequest);

    void togglePause();
    bool paused() const { return status_.state == RenderState::Paused; }

    RenderSession& session() { return session_; }
    const RenderSession& session() const { return session_; }
    int threads() const { return threads_; }
    /// At the time of the last update().
    const RenderStatus& status() const { return status_; }
    double raysPerSecond() const;

    /// The picture of the current state at full size; nothing while it is being compiled or a preview is
    /// traced.
    std::optional<TracedPicture> currentPicture() const;
    /// Its world, or null.
    std::shared_ptr<const trace::World> currentWorld() const;
    /// The latest picture that has at least one sample of every pixel; perhaps a preview, or of another view.
    const std::optional<TracedPicture>& whole() const { return whole_; }
    /// Whether a picture is being compiled or rendered.
    bool busy() const;

    /// The estimated error of the current picture and its forecast; nothing before the first estimate.
    std::optional<ErrorForecast> forecast() const;
    /// Why tracing ended before all samples were taken; nothing if it did not.
    std::optional<StopReason> stopReason() const { return stopReason_; }

  private:
    using Clock = std::chrono::steady_clock;

    int affordableDivisor(const ViewRequest& viewRequest) const;
    int nextDivisor(const ViewRequest& viewRequest, const RenderRequest& full) const;
    std::optional<int> shownDivisor(const RenderRequest& full) const;
    bool isLate(const RenderRequest& full) const;
    bool mayInterrupt() const;
    void takeWhole();
    void measureSpeed();
    void submit(RenderRequest request, bool coarse);
    void resume(const ViewRequest& viewRequest, const RenderRequest& full);
    void updateRasterised(const ViewRequest& viewRequest);
    void updateErrorEstimate(const ViewRequest& viewRequest);
    void applyStopCriteria(const ViewRequest& viewRequest);

    /// Leaves a core to the window while something moves.
    void yieldCore(bool moving);

    int threads_;
    bool yields_;  ///< the number of threads was not given
    std::optional<oneapi::tbb::global_control> yielded_;
    RenderSession session_;
    RenderStatus status_;
    std::optional<RenderRequest> submitted_;
    std::optional<TracedPicture> whole_;
    bool coarse_ = false;   ///< the latest submitted render is a preview
    bool resting_ = false;  ///< interrupted, because the rasterised view is shown
    Clock::time_point submittedAt_{};
    double pixelsPerSecond_;  ///< estimated: samples traced per second

    StopCriteria stopCriteria_;
    std::optional<StopReason> stopReason_;
    using ErrorMonitorPtr = std::shared_ptr<const measure::ErrorMonitor>;
    ErrorMonitorPtr monitor_;                            ///< with the estimates so far
    std::shared_ptr<const render::Film> estimatedFilm_;  ///< that monitor_ observes
    BackgroundJob<ErrorMonitorPtr> estimation_;          ///< of the monitor with one more estimate
};

}  // namespace rayscope::viewer
