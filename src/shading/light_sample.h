#pragma once
#include <rayscope/scene.h>
#include <rayscope/settings.h>
#include <rayscope/vector.h>

#include <variant>

namespace rayscope::shading {

/// A position on a light and the light's colour there.
struct LightSample {
    glm::dvec3 position;
    glm::dvec3 color;
};

/// Maps a point of the unit square onto the light, uniformly in length or area. A segment uses u.x only, a
/// point light neither.
inline LightSample sampleLight(const PointLight& light, const glm::dvec2&) {
    return {glm::dvec3(light.position), glm::dvec3(light.color)};
}
inline LightSample sampleLight(const SegmentLight& light, const glm::dvec2& u) {
    const glm::dvec3 a(light.endpoints[0]), b(light.endpoints[1]);
    return {glm::mix(a, b, u.x), glm::mix(glm::dvec3(light.colors[0]), glm::dvec3(light.colors[1]), u.x)};
}
inline LightSample sampleLight(const ParallelogramLight& light, const glm::dvec2& u) {
    const glm::dvec3 position =
        glm::dvec3(light.corner) + u.x * glm::dvec3(light.edges[0]) + u.y * glm::dvec3(light.edges[1]);
    const glm::dvec3 near = glm::mix(glm::dvec3(light.colors[0]), glm::dvec3(light.colors[1]), u.x);
    const glm::dvec3 far = glm::mix(glm::dvec3(light.colors[2]), glm::dvec3(light.colors[3]), u.x);
    return {position, glm::mix(near, far, u.y)};
}

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

/// Number of coordinates of `u` that sampleLight() uses.
constexpr int dimensionsOf(const PointLight&) { return 0; }
constexpr int dimensionsOf(const SegmentLight&) { return 1; }
constexpr int dimensionsOf(const ParallelogramLight&) { return 2; }
inline int dimensionsOf(const Light& light) {
    return std::visit([](const auto& shape) { return dimensionsOf(shape); }, light.shape);
}

}  // namespace rayscope::shading
