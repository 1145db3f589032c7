#pragma once
#include <cmath>
#include <numbers>

#include <rayscope/vector.h>

#include "sampling/hash.h"

namespace rayscope::measure {

/// The random numbers of one ray, a function of seed and index (SplitMix64).
class LabRandom {
  public:
    LabRandom(std::uint64_t seed, std::uint64_t index) : state_(sampling::hashPair(seed, index)) {}

    double real() { return static_cast<double>(next() >> 11) * 0x1p-53; }  ///< [0, 1)
    double real(double low, double high) { return low + (high - low) * real(); }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
    bool coin() { return next() >> 63 != 0; }
    glm::dvec3 onSphere() {
        const double z = real(-1.0, 1.0), phi = real(0.0, 2.0 * std::numbers::pi), r = std::sqrt(1.0 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }

  private:
    std::uint64_t next() { return sampling::mix(state_ += 0x9e3779b97f4a7c15u); }
    std::uint64_t state_;
};

}  // namespace rayscope::measure
