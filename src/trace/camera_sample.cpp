#include "trace/camera_sample.h"

namespace rayscope {

bool hasSingleCameraRays(const World& world) {
    return !world.camera.hasLens() || (world.settings.lensSamples == 1 && !(world.settings.sharpZone > 0.0f));
}

}  // namespace rayscope
