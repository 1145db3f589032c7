#pragma once
#include <rayscope/render_session.h>
#include <chrono>
#include <future>
#include <memory>
#include <optional>

#include "measure/target/error_monitor.h"
#include "viewer/model/edit_state.h"

namespace rayscope::viewer {

/// When a picture is good enough, before it has all its samples or long after.
struct StopCriteria {
    bool byError = false;  ///< go on until the error is below `error`, however many samples that takes
    float error = 0.005f;  ///< root mean squared error of linear values
    float confidence = 0.95f;
    bool byTime = false;  ///< stop after `seconds` of tracing
    float seconds = 30.0f;
    bool operator==(const StopCriteria&) const = default;
};

/// Decides what the session renders at any moment: a coarse picture that keeps up with the hand while the
/// camera moves or something was edited, then the current state at full size; and one sample per pixel (which
/// keeps the world compiled for debug rays) while the rasterised view is shown.
class RenderControl {
  public:
    /// `threads` 0 leaves one core to the window.
    explicit RenderControl(int threads);

    struct ViewRequest {
        EditState state;
        int width = 1, height = 1;
        bool moving = false;  ///< the camera or a light is being dragged
        bool traced = false;  ///< the ray-traced view is shown
        StopCriteria stopCriteria;
    };
    /// Submits what follows from the viewRequest, if that is something new. To be called in each frame.
    void update(const ViewRequest& viewRequest);

    void togglePause();
    bool paused() const { return status_.state == RenderState::Paused; }

    RenderSession& session() { return session_; }
    int threads() const { return threads_; }
    /// As of the last update().
    const RenderStatus& status() const { return status_; }
    double raysPerSecond() const;

    /// The world of the current state at full size; null while it is being compiled or a coarse one is shown.
    std::shared_ptr<const trace::World> currentWorld() const;
    /// Whether something is on its way to the screen.
    bool busy() const;

    /// What is known of the error of the picture that is traced, and what is to be expected of it; nothing
    /// before the first estimate.
    std::optional<ErrorForecast> forecast() const;
    /// Why tracing ended before all samples were taken; nothing if it did not.
    std::optional<StopReason> stopReason() const { return stopReason_; }

  private:
    using Clock = std::chrono::steady_clock;

    int previewDivisor(const ViewRequest& viewRequest) const;
    bool mayInterrupt() const;
    void submit(RenderRequest request, bool coarse);
    void updateErrorEstimate(const ViewRequest& viewRequest);
    void applyStopCriteria(const ViewRequest& viewRequest);

    int threads_;
    RenderSession session_;
    RenderStatus status_;
    std::optional<RenderRequest> submitted_;
    bool coarse_ = false;  ///< what was submitted last is a preview
    Clock::time_point submittedAt_{};
    double pixelsPerSecond_ = 2e6;  ///< samples traced per second, as seen lately

    StopCriteria stopCriteria_;
    std::optional<StopReason> stopReason_;
    std::shared_ptr<const measure::ErrorMonitor> watch_;
    std::shared_ptr<const render::Film> estimatedFilm_;
    std::future<std::shared_ptr<const measure::ErrorMonitor>> estimating_;
    std::shared_ptr<const measure::ErrorMonitor>
        estimatedFrom_;  ///< what the look that is underway goes on from
};

}  // namespace rayscope::viewer
