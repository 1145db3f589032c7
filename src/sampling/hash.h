#pragma once
#include <cstdint>

namespace rayscope::sampling {

/// A bijection of 64-bit numbers that spreads every input bit over all output bits (the finaliser of
/// SplitMix64: Steele, Lea, Flood 2014, "Fast Splittable Pseudorandom Number Generators", constants of
/// Stafford's variant 13).
constexpr std::uint64_t mix(std::uint64_t x) {
    x ^= x >> 30;
    x *= 0xbf58476d1ce4e5b9u;
    x ^= x >> 27;
    x *= 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// One number from two, in which their order matters.
constexpr std::uint64_t hashPair(std::uint64_t a, std::uint64_t b) {
    return mix(mix(a + 0x9e3779b97f4a7c15u) ^ (b + 0x632be59bd9b4e019u));
}

/// The number that belongs to `b` in the family of a well-mixed `key`: a sequence of SplitMix64 that starts
/// there, entered anywhere.
constexpr std::uint64_t derivedKey(std::uint64_t key, std::uint64_t b) {
    return mix(key + (b + 1) * 0x9e3779b97f4a7c15u);
}

/// The upper 24 bits as a float in [0, 1): every value is exact and none rounds up to 1.
constexpr float toUnitFloat(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

}  // namespace rayscope::sampling
