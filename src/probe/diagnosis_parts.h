#pragma once
// The parts of diagnosePixel(): one function per symptom.
#include <optional>

#include "probe/diagnosis.h"
#include "probe/pixel_samples.h"
#include "trace/world.h"

namespace rayscope::probe {

/// The recorded samples of a pixel.
struct PixelEvidence {
    const trace::World& world;
    std::uint64_t seed;
    std::vector<RayTree> trees;
    SampleStatistics statistics;
};
PixelEvidence gatherEvidence(const trace::World& world, std::uint64_t seed, int x, int y, int samples,
                             const std::function<void()>& beforeSample, const std::stop_token& stop);

std::optional<Diagnosis> diagnoseNonFinite(const PixelEvidence& pixel);
std::optional<Diagnosis> diagnoseBlack(const PixelEvidence& pixel);
std::optional<Diagnosis> diagnoseBright(const PixelEvidence& pixel);
std::optional<Diagnosis> diagnoseNoisy(const PixelEvidence& pixel);
std::optional<Diagnosis> diagnoseSlow(const PixelEvidence& pixel);

/// "triangle 7 of mesh 0 'box'".
std::string locationText(const trace::World& world, std::uint32_t primitive);
/// The largest angle between a vertex normal and the geometric normal, in degrees; 0 without vertex normals,
/// NaN if one is not a number.
double normalDeviation(const trace::World& world, const RayNode& node, float time);
/// A primitive that coincides with another, both in leaves that the ray visits or culls; kNoPrimitive if
/// there is none.
std::uint32_t findDuplicateAlong(const trace::World& world, const Ray& ray, float time);

}  // namespace rayscope::probe
