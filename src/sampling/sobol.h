#pragma once
#include <cstdint>

namespace rayscope {

inline constexpr int kSobolDimensions = 8;

/// Coordinate `dimension` of point `index` of the Sobol sequence, as a 32-bit binary fraction
/// (direction numbers: Joe and Kuo 2008, "Constructing Sobol sequences with better two-dimensional
/// projections").
std::uint32_t sobol(std::uint32_t index, int dimension);

/// Owen's nested uniform scrambling of a 32-bit binary fraction by hashing, each seed another scrambling
/// (Burley 2020, "Practical Hash-based Owen Scrambling", after Laine and Karras 2011).
std::uint32_t owenScramble(std::uint32_t value, std::uint32_t seed);

}  // namespace rayscope
