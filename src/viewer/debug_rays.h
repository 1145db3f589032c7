#pragma once
#include <rayscope/probe.h>
#include <memory>
#include <optional>

#include "viewer/edit_state.h"
#include "viewer/overlay/debug_rays_overlay.h"

namespace rayscope::viewer {

/// The rays of one pixel as they were recorded. They stay until they are cleared; when scene, settings or
/// camera have changed since, they are stale.
class DebugRays {
  public:
    /// Records a sample of pixel (x, y) of `world`, which was compiled from `state`. With a film, whether the
    /// replay gives what the film holds is found out too.
    void shoot(std::shared_ptr<const World> world, const EditState& state, glm::ivec2 imageSize,
               SampleName name, const Film* film);
    void clear() {
        shot_.reset();
        ++version_;
    }

    struct Shot {
        RayTree tree;
        EditState state;
        glm::ivec2 imageSize{1};
        std::shared_ptr<const World> world;
        std::optional<ReplayVerdict> verdict;
    };
    const Shot* shot() const { return shot_ ? &*shot_ : nullptr; }
    bool staleFor(const EditState& state, glm::ivec2 imageSize) const;
    /// Grows when the recorded rays change.
    int version() const { return version_; }

    DebugRayFilter filter;

  private:
    std::optional<Shot> shot_;
    int version_ = 0;
};

}  // namespace rayscope::viewer
