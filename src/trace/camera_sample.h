#pragma once
#include <rayscope/path.h>

#include "sampling/sample_stream.h"
#include "sampling/warp.h"
#include "trace/world.h"

namespace rayscope::trace {

/// Position on the image plane and time of a sample.
struct CameraSample {
    glm::dvec2 pixel;  ///< pixel coordinates, as of Camera
    float time;        ///< of the shutter in [0, 1); 0 if nothing moves

    CameraSample(const World& world, const sampling::SampleStream& stream, const SampleId& sample)
        : CameraSample(world, stream, sample, stream.get2D(sampling::Dim::Pixel)) {}
    /// `inPixel` must be the number of the stream for Dim::Pixel.
    CameraSample(const World& world, const sampling::SampleStream& stream, const SampleId& sample,
                 const glm::vec2& inPixel)
        : pixel(glm::dvec2(sample.x, sample.y) + glm::dvec2(inPixel)),
          time(world.moves ? stream.get1D(sampling::Dim::Time) : 0.0f) {}
};

/// Whether each sample traces exactly one camera ray, which does not depend on the scene's geometry.
inline bool hasSingleCameraRays(const World& world) {
    return !world.camera.hasLens() || (world.settings.lensSamples == 1 && !(world.settings.sharpZone > 0.0f));
}
/// The camera ray of a sample where hasSingleCameraRays().
inline Ray singleCameraRay(const World& world, const sampling::SampleStream& stream,
                           const CameraSample& sample) {
    if (!world.camera.hasLens()) return world.camera.pinholeRay(sample.pixel);
    const glm::dvec2 aperture =
        sampling::sampleAperture(world.settings.lensShape, stream.get2D(sampling::Dim::Lens));
    return world.camera.lensRay(sample.pixel, aperture);
}

}  // namespace rayscope::trace
