#pragma once
#include <rayscope/scene.h>
#include <rayscope/settings.h>
#include <rayscope/vector.h>

namespace rayscope::shading {

/// A position on a light and the light's colour there.
struct LightSample {
    glm::dvec3 position;
    glm::dvec3 color;
};

/// Maps a point of the unit square onto the light, uniformly in length or area. A segment uses u.x only, a
/// point light neither.
LightSample sampleLight(const Light& light, const glm::vec2& u);

/// Number of samples of a light under the settings, as a grid.
struct LightSampleGrid {
    int columns = 1, rows = 1;
    int count() const { return columns * rows; }
};
LightSampleGrid sampleGrid(const Light& light, const Settings& settings);

/// The most samples of a light, which the settings also have as their upper ends: along a segment, and along
/// each side of a parallelogram. A light in small units, long as it is in them, has no more.
inline constexpr int kMostSegmentSamples = 4096, kMostParallelogramSamples = 100;

/// Whether a number of samples per length exceeds those.
bool isCapped(const Light& light, const Settings& settings);

/// Number of coordinates of `u` that sampleLight() uses: 0 for a point, 1 for a segment, 2 for a
/// parallelogram.
int dimensionsOf(const Light& light);

}  // namespace rayscope::shading
