#pragma once
// One function per symptom; each sees the recorded samples of the pixel.
#include <optional>

#include "probe/diagnosis.h"
#include "probe/pixel_samples.h"
#include "trace/world.h"

namespace rayscope::probe {

/// The samples of a pixel with everything that is asked of them more than once.
struct PixelEvidence {
    const trace::World& world;
    std::uint64_t seed;
    std::vector<RayTree> trees;
    SampleStatistics statistics;
};
PixelEvidence gatherEvidence(const trace::World& world, std::uint64_t seed, int x, int y, int samples,
                             const std::function<void()>& beforeSample);

std::optional<Diagnosis> diagnoseNonFinite(const PixelEvidence& pixel);
std::optional<Diagnosis> diagnoseBlack(const PixelEvidence& pixel);
std::optional<Diagnosis> diagnoseBright(const PixelEvidence& pixel);
std::optional<Diagnosis> diagnoseNoisy(const PixelEvidence& pixel);
std::optional<Diagnosis> diagnoseSlow(const PixelEvidence& pixel);

/// "triangle 7 of mesh 0 'box'".
std::string locationText(const trace::World& world, std::uint32_t primitive);
/// The largest angle, in degrees, between the normals that a triangle's vertices have and its own; 0 without
/// normals. NaN if a normal is not a number.
double normalDeviation(const trace::World& world, const RayNode& node, float time);
/// A primitive in a leaf that the ray searches which lies exactly where another one does; kNoPrimitive if
/// there is none.
std::uint32_t findDuplicateAlong(const trace::World& world, const Ray& ray, float time);

}  // namespace rayscope::probe
