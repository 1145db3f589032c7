#pragma once
// Reasons for a pixel being black, bright, noisy, slow or not a number, from its recorded rays.
#include <rayscope/probe.h>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace rayscope::probe {

enum class Symptom { NonFinite, Black, Bright, Noisy, Slow };

enum class Cause {
    Unknown,
    NothingHit,          ///< all camera rays miss, and there is no environment
    NoLight,             ///< the scene has no light
    LightOccluded,       ///< geometry between surface and lights
    LightBehindSurface,  ///< the surface faces away from all lights
    BlackMaterial,       ///< kd and ks are 0
    BadNormal,           ///< a shading normal is not a number, or far from the geometric one
    StrongLight,         ///< one light exceeds the display range
    Overflow,            ///< finite terms whose sum or product is infinite
    RareBrightPaths,     ///< few samples contribute most of the radiance
    GlossyReflection,    ///< variance of glossy rays
    Penumbra,            ///< a light is partly occluded
    Edge,                ///< samples hit different surfaces
    ManyRays,            ///< more rays than the median pixel
    ExpensiveRays,       ///< more nodes per ray than the median pixel
    DuplicateGeometry,   ///< coincident primitives
};
std::string_view nameOf(Symptom symptom);
std::string_view nameOf(Cause cause);

/// A ray that supports a diagnosis.
struct Evidence {
    int sample = 0;
    int node = -1, shadow = -1;  ///< index into the tree's nodes or shadow rays
};

struct Diagnosis {
    Symptom symptom = Symptom::Black;
    Cause cause = Cause::Unknown;
    std::string sentence;
    std::vector<Evidence> evidence;
};

/// "black, light occluded: 8 of 8 shadow rays …" and the evidence.
std::string toText(const Diagnosis& diagnosis);

/// The number of samples to diagnose: spp, at most 64.
int samplesToDiagnose(const Settings& settings);

/// The symptoms of a pixel in its first `samples` samples, the most severe first; empty if there are none. A
/// cause that the rays do not prove is Cause::Unknown. `beforeSample`, if given, is called before each sample
/// and may throw to stop. `stop` is checked within samples, too, and throws Stopped.
std::vector<Diagnosis> diagnosePixel(const trace::World& world, std::uint64_t seed, int x, int y, int samples,
                                     const std::function<void()>& beforeSample = {},
                                     const std::stop_token& stop = {});

}  // namespace rayscope::probe
