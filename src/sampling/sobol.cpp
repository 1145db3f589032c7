#include "sampling/sobol.h"

#include <array>

namespace rayscope::sampling {

namespace {

/// A primitive polynomial over GF(2) of the given degree, its inner coefficients, and the first direction
/// numbers.
struct Polynomial {
    int degree;
    std::uint32_t coefficients;
    std::array<std::uint32_t, 5> first;
};
constexpr std::array<Polynomial, kSobolDimensions - 1> kPolynomials{{{1, 0, {1}},
                                                                     {2, 1, {1, 3}},
                                                                     {3, 1, {1, 3, 1}},
                                                                     {3, 2, {1, 1, 1}},
                                                                     {4, 1, {1, 1, 3, 3}},
                                                                     {4, 4, {1, 3, 5, 13}},
                                                                     {5, 2, {1, 1, 5, 5, 17}}}};

using Directions = std::array<std::uint32_t, 32>;

constexpr Directions directionsOf(int dimension) {
    Directions v{};
    if (dimension == 0) {
        for (std::size_t i = 0; i < 32; ++i) v[i] = 0x80000000u >> i;
        return v;
    }
    const Polynomial& p = kPolynomials[static_cast<std::size_t>(dimension - 1)];
    const auto degree = static_cast<std::size_t>(p.degree);
    for (std::size_t i = 0; i < degree; ++i) v[i] = p.first[i] << (31 - i);
    for (std::size_t i = degree; i < 32; ++i) {
        v[i] = v[i - degree] ^ (v[i - degree] >> degree);
        for (std::size_t k = 1; k < degree; ++k)
            if ((p.coefficients >> (degree - 1 - k)) & 1u) v[i] ^= v[i - k];
    }
    return v;
}

constexpr std::array<SobolTable, kSobolDimensions> makeTables() {
    std::array<SobolTable, kSobolDimensions> tables{};
    for (int dimension = 0; dimension < kSobolDimensions; ++dimension) {
        const Directions v = directionsOf(dimension);
        for (std::size_t byte = 0; byte < 4; ++byte)
            for (std::uint32_t value = 0; value < 256; ++value)
                for (std::size_t bit = 0; bit < 8; ++bit)
                    if ((value >> bit) & 1u)
                        tables[static_cast<std::size_t>(dimension)][byte][value] ^=
                            reverseBits(v[31 - (8 * byte + bit)]);
    }
    return tables;
}
}  // namespace

constinit const std::array<SobolTable, kSobolDimensions> kSobolTables = makeTables();

std::uint32_t sobol(std::uint32_t index, int dimension) {
    return reverseBits(sobolReversed(reverseBits(index), dimension));
}

std::uint32_t owenScramble(std::uint32_t value, std::uint32_t seed) {
    return reverseBits(owenScrambleReversed(reverseBits(value), seed));
}

}  // namespace rayscope::sampling
