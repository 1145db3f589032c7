#include "viewer/debug_rays.h"

namespace rayscope::viewer {

void DebugRays::shoot(std::shared_ptr<const World> world, const EditState& state, glm::ivec2 imageSize,
                      SampleName name, const Film* film) {
    constexpr std::uint64_t kSeed = 0;  // the window renders with this one
    Shot shot{probe(*world, kSeed, name), state, imageSize, world, std::nullopt};
    if (film != nullptr) shot.verdict = verify(*world, *film, kSeed, name.x, name.y);
    shot_ = std::move(shot);
    ++version_;
}

bool DebugRays::staleFor(const EditState& state, glm::ivec2 imageSize) const {
    return shot_ && (shot_->state.scene != state.scene || shot_->state.camera != state.camera ||
                     shot_->imageSize != imageSize ||
                     changed(shot_->state.settings, state.settings) > Invalidates::Display);
}

}  // namespace rayscope::viewer
