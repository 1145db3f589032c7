#pragma once
#include <array>
#include <cstdint>

namespace rayscope::sampling {

inline constexpr int kSobolDimensions = 8;

/// Coordinate `dimension` of point `index` of the Sobol sequence, as a 32-bit binary fraction
/// (direction numbers: Joe and Kuo 2008, "Constructing Sobol sequences with better two-dimensional
/// projections").
std::uint32_t sobol(std::uint32_t index, int dimension);

/// Owen's nested uniform scrambling of a 32-bit binary fraction by hashing, each seed another scrambling
/// (Burley 2020, "Practical Hash-based Owen Scrambling", after Laine and Karras 2011).
std::uint32_t owenScramble(std::uint32_t value, std::uint32_t seed);

constexpr std::uint32_t reverseBits(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    return __builtin_bswap32(x);
}

/// The XOR of the direction numbers of one byte of the index, for each of its four bytes: a coordinate is
/// four lookups. Index and value are in reversed bit order.
using SobolTable = std::array<std::array<std::uint32_t, 256>, 4>;
extern const std::array<SobolTable, kSobolDimensions> kSobolTables;

/// sobol() and owenScramble() with arguments and results in reversed bit order. Scrambling works in this
/// order, so a chain of calls reverses bits only at its ends.
inline std::uint32_t sobolReversed(std::uint32_t reversedIndex, int dimension) {
    const SobolTable& table = kSobolTables[static_cast<std::size_t>(dimension)];
    return table[0][reversedIndex & 255u] ^ table[1][(reversedIndex >> 8) & 255u] ^
           table[2][(reversedIndex >> 16) & 255u] ^ table[3][reversedIndex >> 24];
}

constexpr std::uint32_t owenScrambleReversed(std::uint32_t reversed, std::uint32_t seed) {
    reversed += seed;
    reversed ^= reversed * 0x6c50b47cu;
    reversed ^= reversed * 0xb82f1e52u;
    reversed ^= reversed * 0xc7afe638u;
    reversed ^= reversed * 0x8d22f6e6u;
    return reversed;
}

}  // namespace rayscope::sampling
