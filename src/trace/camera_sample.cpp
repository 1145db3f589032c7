#include "trace/camera_sample.h"

#include "sampling/warp.h"

namespace rayscope {

bool hasSingleCameraRays(const World& world) {
    return !world.camera.hasLens() || (world.settings.lensSamples == 1 && !(world.settings.sharpZone > 0.0f));
}

Ray singleCameraRay(const World& world, const SampleStream& stream, const CameraSample& sample) {
    if (!world.camera.hasLens()) return world.camera.pinholeRay(sample.pixel);
    const glm::dvec2 aperture = sampleAperture(world.settings.lensShape, stream.get2D(Dim::Lens));
    return world.camera.lensRay(sample.pixel, aperture);
}

}  // namespace rayscope
