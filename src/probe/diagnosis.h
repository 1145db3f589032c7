#pragma once
// Why a pixel is black, bright, noisy, slow or not a number, as far as its rays tell.
#include <rayscope/probe.h>
#include <functional>
#include <string>
#include <vector>

namespace rayscope::probe {

enum class Symptom { NonFinite, Black, Bright, Noisy, Slow };

enum class Cause {
    Unknown,
    NothingHit,          ///< rays miss everything, and there is no environment
    NoLight,             ///< the scene has no light
    LightOccluded,       ///< something stands between surface and lights
    LightBehindSurface,  ///< the surface faces away from all lights
    BlackMaterial,       ///< the surface reflects nothing
    BadNormal,           ///< a shading normal that is not a number, or far from the surface's own
    StrongLight,         ///< a light brings more than the picture can show
    Overflow,            ///< finite terms whose sum or product is not
    RareBrightPaths,     ///< few samples bring most of the light
    GlossyReflection,    ///< reflected rays scatter
    Penumbra,            ///< a light is partly hidden
    Edge,                ///< samples meet different surfaces
    ManyRays,            ///< more rays than elsewhere
    ExpensiveRays,       ///< rays that search longer than elsewhere
    DuplicateGeometry,   ///< surfaces lie in the same place
};
std::string_view nameOf(Symptom symptom);
std::string_view nameOf(Cause cause);

/// A ray that a sentence rests on.
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

/// "black, light blocked: 8 of 8 shadow rays …" and the rays that it rests on.
std::string toText(const Diagnosis& explanation);

/// How many samples are worth looking at: those that the picture takes, but no more than 64.
int samplesToDiagnose(const Settings& settings);

/// What stands out about the pixel in its first `samples` samples, the worst first; nothing if it is
/// ordinary. Says "unknown" rather than guess. `beforeSample`, if given, is called before each of the samples
/// and may throw to stop.
std::vector<Diagnosis> diagnosePixel(const trace::World& world, std::uint64_t seed, int x, int y, int samples,
                                     const std::function<void()>& beforeSample = {});

}  // namespace rayscope::probe
