#pragma once
#include <rayscope/vector.h>
#include <array>
#include <cstdint>

namespace rayscope::measure {

/// An exact sum of products of up to three floats, for geometric predicates.
///
/// A finite float is a multiple of 2^-149 below 2^128, so a product of three is a multiple of 2^-447 below
/// 2^384. The sum is kept as one integer in units of 2^-448, in two's complement; its 896 bits hold 2^60
/// addends. Much slower than a filtered predicate.
class ExactSum {
  public:
    /// Adds a · b · c; all finite.
    void add(float a, float b, float c = 1.0f);
    void subtract(float a, float b, float c = 1.0f) { add(-a, b, c); }

    /// −1, 0 or 1.
    int sign() const;
    /// Relative error at most 2^-62 where long double has a mantissa of 64 bits, otherwise its precision.
    long double value() const;

    ExactSum& operator+=(const ExactSum& other);
    ExactSum operator-() const;

  private:
    static constexpr int kWords = 14;
    static constexpr int kLowestExponent = -448;
    std::array<std::uint64_t, kWords> words_{};
};

/// Adds the determinant with the columns a, b, c: a · (b × c). Six products.
void addDeterminant(ExactSum& sum, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Six times the signed volume of a, b, c and p: positive where p lies on the side to which (b − a) × (c − a)
/// points.
ExactSum signedVolume(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& p);

}  // namespace rayscope::measure
