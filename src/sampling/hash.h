#pragma once
#include <cstdint>

namespace rayscope::sampling {

/// A bijection of 64-bit numbers in which every input bit affects all output bits (the finaliser of
/// SplitMix64: Steele, Lea, Flood 2014, "Fast Splittable Pseudorandom Number Generators", constants of
/// Stafford's variant 13).
constexpr std::uint64_t mix(std::uint64_t x) {
    x ^= x >> 30;
    x *= 0xbf58476d1ce4e5b9u;
    x ^= x >> 27;
    x *= 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// A hash of an ordered pair.
constexpr std::uint64_t hashPair(std::uint64_t a, std::uint64_t b) {
    return mix(mix(a + 0x9e3779b97f4a7c15u) ^ (b + 0x632be59bd9b4e019u));
}

/// Element `b` of the SplitMix64 sequence whose state starts at `key`, a value that is well mixed.
constexpr std::uint64_t derivedKey(std::uint64_t key, std::uint64_t b) {
    return mix(key + (b + 1) * 0x9e3779b97f4a7c15u);
}

/// The upper 24 bits as a float in [0, 1): every value is exact and none rounds up to 1.
constexpr float toUnitFloat(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

}  // namespace rayscope::sampling
