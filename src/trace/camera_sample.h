#pragma once
#include <rayscope/path.h>

#include "sampling/sample_stream.h"
#include "sampling/warp.h"
#include "trace/world.h"

namespace rayscope::trace {

/// Where and when a sample looks.
struct CameraSample {
    glm::dvec2 pixel;
    float time;  ///< of the shutter, 0 if nothing moves

    CameraSample(const World& world, const sampling::SampleStream& stream, const SampleId& name)
        : pixel(glm::dvec2(name.x, name.y) + glm::dvec2(stream.get2D(sampling::Dim::Pixel))),
          time(world.moves ? stream.get1D(sampling::Dim::Time) : 0.0f) {}
};

/// Whether each sample of a world is one camera ray that depends on nothing else.
inline bool hasSingleCameraRays(const World& world) {
    return !world.camera.hasLens() || (world.settings.lensSamples == 1 && !(world.settings.sharpZone > 0.0f));
}
/// That ray.
inline Ray singleCameraRay(const World& world, const sampling::SampleStream& stream,
                           const CameraSample& sample) {
    if (!world.camera.hasLens()) return world.camera.pinholeRay(sample.pixel);
    const glm::dvec2 aperture =
        sampling::sampleAperture(world.settings.lensShape, stream.get2D(sampling::Dim::Lens));
    return world.camera.lensRay(sample.pixel, aperture);
}

}  // namespace rayscope::trace
