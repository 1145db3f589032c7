#pragma once
#include <rayscope/probe.h>
#include <memory>
#include <optional>

#include "probe/diagnosis.h"
#include "probe/pixel_samples.h"
#include "probe/traversal_log.h"
#include "viewer/model/edit_state.h"
#include "viewer/overlay/debug_rays_overlay.h"
#include "viewer/overlay/surface_overlay.h"
#include "viewer/overlay/traversal_overlay.h"

namespace rayscope::viewer {

/// The rays of one pixel as they were recorded. They stay until they are cleared; when scene, settings or
/// camera have changed since, they are stale.
class DebugRays {
  public:
    struct PixelRecording {
        std::vector<RayTree> trees;  ///< of the chosen sample, or of all samples that the budget holds
        std::size_t chosen = 0;      ///< index into `trees`
        int samples = 1;             ///< that the pixel has with these settings
        EditState state;
        glm::ivec2 imageSize{1};
        std::shared_ptr<const trace::World> world;
        std::optional<ReplayResult> verdict;
        probe::PixelSamples pixel;  ///< of all samples, at most maxSamples
        probe::SampleStatistics statistics;
        std::optional<std::vector<probe::Diagnosis>> diagnosis;

        const RayTree& tree() const { return trees[chosen]; }
    };

    /// Records the pixel of `world`, which was compiled from `state`. With a film, whether the replay gives
    /// what the film holds is found out too.
    void recordPixel(std::shared_ptr<const trace::World> world, const EditState& state, glm::ivec2 imageSize,
                     SampleId name, const render::Film* film);
    void clear();
    static constexpr int kMaxSamples = 4096, kMaxLiveSamples = 64;
    int maxSamples = kMaxSamples;  ///< that are replayed for the strip
    const PixelRecording* recording() const { return recording_ ? &*recording_ : nullptr; }
    bool isStaleFor(const EditState& state, glm::ivec2 imageSize) const;

    /// Records another sample of the pixel, or all of them.
    void selectSample(int index);
    void showAllSamples(bool all);
    /// Compares with the film again if that has other samples than at the time of the last verdict.
    void updateReplay(const render::Film& film);

    /// Finds out what stands out about the pixel, if that was not done yet.
    const std::vector<probe::Diagnosis>& explain();
    /// Goes to the ray that a sentence rests on.
    void show(const probe::Evidence& evidence);

    /// The chosen ray; its traversal is recorded as soon as it is to be shown.
    void select(RaySelection selection);
    RaySelection selection() const { return filter.selected; }
    void hideSelected();
    void updateTraversal();
    /// The traversal of the chosen ray, or of the camera ray, through each motionGroup.
    const std::vector<probe::TraversalLog>& traversals() const { return traversals_; }
    void step(int by);

    /// What is kept of a pixel, to compare it with others.
    struct Pin {
        glm::ivec2 pixel{0};
        std::string surface;  ///< what its first sample shows
        double mean = 0.0, error = 0.0, raysPerSample = 0.0;
    };
    std::vector<Pin> pins;
    void pin();

    /// Grows when the recorded rays or the traversal change.
    int version() const { return version_; }

    DebugRayFilter filter;
    TraversalOverlayOptions traversal;
    SurfaceOverlayOptions surface;
    std::size_t budget = std::size_t{64} << 20;  ///< bytes of recorded trees

  private:
    void record();

    std::optional<PixelRecording> recording_;
    std::vector<probe::TraversalLog> traversals_;
    std::optional<RaySelection> traversedRay_;       ///< whose traversal is recorded …
    BvhLayout traversedLayout_ = BvhLayout::Binary;  ///< … through which tree
    int sample_ = 0;
    int version_ = 0;
};

}  // namespace rayscope::viewer
