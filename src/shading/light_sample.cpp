#include "shading/light_sample.h"

#include <algorithm>
#include <cmath>

#include "math/vectors.h"

namespace rayscope::shading {

namespace {

/// Samples along an edge: the value of the setting, or that many per unit of length, from 1 to `most`.
int alongLength(int setting, double length, LightSampleCount rule, int most) {
    if (rule == LightSampleCount::Fixed) return setting;
    return static_cast<int>(std::clamp(std::floor(setting * length), 1.0, static_cast<double>(most)));
}

}  // namespace

LightSampleGrid sampleGrid(const Light& light, const Settings& settings) {
    const LightSampleCount rule = settings.lightSampleCount;
    if (const auto* segment = std::get_if<SegmentLight>(&light.shape)) {
        const double length =
            glm::distance(glm::dvec3(segment->endpoints[0]), glm::dvec3(segment->endpoints[1]));
        return {alongLength(settings.segmentSamples, length, rule, kMostSegmentSamples), 1};
    }
    if (const auto* area = std::get_if<ParallelogramLight>(&light.shape)) {
        const auto along = [&](int edge) {
            const double length = glm::length(glm::dvec3(area->edges[static_cast<std::size_t>(edge)]));
            return alongLength(settings.parallelogramSamples, length, rule, kMostParallelogramSamples);
        };
        return {along(0), along(1)};
    }
    return {};
}

bool isCapped(const Light& light, const Settings& settings) {
    if (settings.lightSampleCount == LightSampleCount::Fixed) return false;
    if (const auto* segment = std::get_if<SegmentLight>(&light.shape))
        return settings.segmentSamples * math::distance(segment->endpoints[0], segment->endpoints[1]) >=
               kMostSegmentSamples + 1;
    if (const auto* area = std::get_if<ParallelogramLight>(&light.shape))
        return settings.parallelogramSamples *
                   std::max(math::length(area->edges[0]), math::length(area->edges[1])) >=
               kMostParallelogramSamples + 1;
    return false;
}

}  // namespace rayscope::shading
