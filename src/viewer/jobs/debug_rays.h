#pragma once
#include <rayscope/probe.h>
#include <memory>
#include <optional>

#include "probe/diagnosis.h"
#include "probe/pixel_samples.h"
#include "probe/traversal_log.h"
#include "viewer/jobs/background_job.h"
#include "viewer/model/edit_state.h"
#include "viewer/model/overlay_options.h"

namespace rayscope::viewer {

/// The recorded rays of one pixel, until they are cleared. They follow the settings, the lights and the lens:
/// after a change the same pixel is recorded again, from the camera position of the first recording, so that
/// the camera can be moved to look at the rays. One sample is recorded at once; replay, further samples and
/// diagnosis are background jobs.
class DebugRays {
  public:
    struct PixelRecording {
        std::vector<RayTree> trees;  ///< of the selected sample, or of all samples within the budget
        std::size_t chosen = 0;      ///< the selected sample, an index into `trees`
        RenderRequest request;       ///< that the rays are of, with the samples of the pixel
        std::shared_ptr<const trace::World> world;
        std::optional<ReplayResult> replayResult;
        probe::PixelSamples pixel;  ///< the first sample until replayed, then at most maxSamples
        probe::SampleStatistics statistics;
        std::optional<std::vector<probe::Diagnosis>> diagnosis;

        const RayTree& tree() const { return trees[chosen]; }
        int samples() const { return request.settings.spp; }
    };

    enum class Compare { WithNothing, WithFilm };
    /// Records sample `id` of a pixel that has `samples` samples, and starts the replay of these, which may
    /// be compared with the film of the picture.
    void recordPixel(const TracedPicture& picture, int samples, SampleId id, Compare compare);
    /// Records the pixel again if the state differs from the recording in what changes its rays, besides the
    /// position of the camera, unless the rays are frozen. Shares the world of `picture` if that is of the
    /// state, and does nothing otherwise. Another scene clears the rays.
    void follow(const EditState& state, const std::optional<TracedPicture>& picture);
    bool frozen = false;  ///< the rays do not follow
    /// Whether follow() would record again if the rays were not frozen.
    bool isOutdated(const EditState& state) const;
    void clear();
    static constexpr int kMaxSamples = 4096, kMaxLiveSamples = 64;
    int maxSamples = kMaxSamples;  ///< to replay for the chart of samples
    const PixelRecording* recording() const { return recording_ ? &*recording_ : nullptr; }
    /// Whether the rays are of a pixel of the picture of this state in this size.
    bool isOf(const EditState& state, glm::ivec2 imageSize) const;

    /// Takes over the results of the jobs. To be called in each frame.
    void update();
    bool busy() const {
        return replay_.busy() || verification_.busy() || sampleTrees_.busy() || diagnosis_.busy() ||
               following_.busy();
    }

    bool replaying() const { return replay_.busy(); }
    double replayProgress() const { return replay_.progress(); }
    void cancelReplay() { replay_.cancel(); }
    /// Compares with the film of the picture unless that has been done with as many samples.
    void verify(const TracedPicture& picture);

    /// Records another sample of the pixel, or all of them.
    void selectSample(int index);
    void showAllSamples(bool all);

    /// The diagnosis of the pixel. The first call starts it; null until it is done.
    const std::vector<probe::Diagnosis>* diagnose();
    bool diagnosing() const { return diagnosis_.busy(); }
    double diagnosisProgress() const { return diagnosis_.progress(); }
    void cancelDiagnosis() { diagnosis_.cancel(); }
    /// Starts a cancelled diagnosis again.
    void restartDiagnosis() { diagnosisRequested_ = false; }
    const std::string& diagnosisError() const { return diagnosis_.error(); }
    /// Selects the ray that a diagnosis names.
    void show(const probe::Evidence& evidence);

    /// The selected ray; its traversal is recorded when it is shown.
    void select(RaySelection selection);
    RaySelection selection() const { return filter.selected; }

    /// Which rays there are and which of them are hidden, for undo.
    struct Shown {
        bool whole = false;                         ///< replaces the recording, too
        std::optional<PixelRecording> recording{};  ///< if `whole`
        std::vector<RaySelection> hidden{};
        int tree = 0;  ///< the number of the ray tree that `hidden` belongs to; else nothing is hidden
    };
    /// Replaces what is shown; returns what was.
    Shown exchange(Shown shown);
    /// What is shown without the selected ray.
    Shown withoutSelected() const;
    void updateTraversal();
    /// The traversals of the selected ray, or of the camera ray: one per motion group.
    const std::vector<probe::TraversalLog>& traversals() const { return traversals_; }
    void step(int by);

    /// Statistics of a pixel, kept for comparison with others.
    struct Pin {
        glm::ivec2 pixel{0};
        std::string surface;  ///< that the first sample hits
        double mean = 0.0, error = 0.0, raysPerSample = 0.0;
        std::optional<glm::vec3> position{};  ///< on the surface
    };
    std::vector<Pin> pins;
    /// Pins the recorded pixel, as soon as its samples are replayed.
    void pin();

    /// Increases whenever the recorded rays or the traversal change.
    int version() const { return version_; }

    DebugRayFilter filter;
    TraversalOverlayOptions traversal;
    SurfaceOverlayOptions surface;
    std::size_t budget = std::size_t{64} << 20;  ///< bytes of recorded ray trees

  private:
    struct Replay {
        std::optional<ReplayResult> replayResult;
        probe::PixelSamples pixel;
        probe::SampleStatistics statistics;
    };
    struct Followed {
        RenderRequest request;
        std::shared_ptr<const trace::World> world;
    };
    RenderRequest followed(const EditState& state) const;
    void startRecording(RenderRequest request, std::shared_ptr<const trace::World> world, SampleId id,
                        std::shared_ptr<const render::Film> film);
    void recordFollowed(Followed followed);
    void startReplay(SampleId id, std::shared_ptr<const render::Film> film);
    void recordSample();
    void recordAllSamples();
    void clearSelection();
    void resetSelection();

    std::optional<PixelRecording> recording_;
    BackgroundJob<Replay> replay_;
    BackgroundJob<ReplayResult> verification_;
    BackgroundJob<std::vector<RayTree>> sampleTrees_;
    BackgroundJob<std::vector<probe::Diagnosis>> diagnosis_;
    BackgroundJob<Followed> following_;
    bool diagnosisRequested_ = false, pinRequested_ = false;

    std::vector<probe::TraversalLog> traversals_;
    std::optional<RaySelection> traversedRay_;  ///< whose traversal is recorded, in a tree of this layout:
    BvhLayout traversedLayout_ = BvhLayout::Binary;
    int sample_ = 0;
    int tree_ = 0, trees_ = 0;  ///< number of the selected ray tree, and of the latest one
    int version_ = 0;
};

}  // namespace rayscope::viewer
