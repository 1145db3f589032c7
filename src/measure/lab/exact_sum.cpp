#include "measure/lab/exact_sum.h"

#include <bit>
#include <cmath>

namespace rayscope::measure {

namespace {

__extension__ using Wide = unsigned __int128;

/// A float as mantissa · 2^exponent.
struct Parts {
    std::uint32_t mantissa;
    int exponent;
    bool negative;
};

Parts split(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    const std::uint32_t fraction = bits & 0x7fffffu;
    const int biased = static_cast<int>(bits >> 23 & 0xffu);
    const bool denormal = biased == 0;
    return {denormal ? fraction : fraction | 0x800000u, (denormal ? 1 : biased) - 150, bits >> 31 != 0};
}

}  // namespace

void ExactSum::add(float a, float b, float c) {
    const Parts x = split(a), y = split(b), z = split(c);
    // 72 bits, shifted by less than 64: three words.
    const Wide mantissa = static_cast<Wide>(std::uint64_t{x.mantissa} * y.mantissa) * z.mantissa;
    if (mantissa == 0) return;
    const int shift = x.exponent + y.exponent + z.exponent - kLowestExponent;
    const auto first = static_cast<std::size_t>(shift / 64);
    const int within = shift % 64;
    const Wide shifted = mantissa << within;
    const std::uint64_t addend[3] = {
        static_cast<std::uint64_t>(shifted), static_cast<std::uint64_t>(shifted >> 64),
        within > 56 ? static_cast<std::uint64_t>(mantissa >> (128 - within)) : 0};

    const bool negative = x.negative != y.negative ? !z.negative : z.negative;
    std::uint64_t carry = negative;  // −n = ~n + 1
    for (std::size_t i = first; i < kWords; ++i) {
        const std::uint64_t magnitude = i - first < 3 ? addend[i - first] : 0;
        const Wide sum = static_cast<Wide>(words_[i]) + (negative ? ~magnitude : magnitude) + carry;
        words_[i] = static_cast<std::uint64_t>(sum);
        carry = static_cast<std::uint64_t>(sum >> 64);
    }
}

ExactSum& ExactSum::operator+=(const ExactSum& other) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < kWords; ++i) {
        const Wide sum = static_cast<Wide>(words_[i]) + other.words_[i] + carry;
        words_[i] = static_cast<std::uint64_t>(sum);
        carry = static_cast<std::uint64_t>(sum >> 64);
    }
    return *this;
}

ExactSum ExactSum::operator-() const {
    ExactSum result;
    std::uint64_t carry = 1;
    for (std::size_t i = 0; i < kWords; ++i) {
        const Wide sum = static_cast<Wide>(~words_[i]) + carry;
        result.words_[i] = static_cast<std::uint64_t>(sum);
        carry = static_cast<std::uint64_t>(sum >> 64);
    }
    return result;
}

int ExactSum::sign() const {
    if (words_.back() >> 63) return -1;
    for (const std::uint64_t word : words_)
        if (word != 0) return 1;
    return 0;
}

long double ExactSum::value() const {
    const int s = sign();
    if (s == 0) return 0.0L;
    const ExactSum magnitude = s > 0 ? *this : -*this;
    int top = kWords - 1;
    while (magnitude.words_[static_cast<std::size_t>(top)] == 0) --top;
    long double sum = 0.0L;
    for (int i = std::max(0, top - 2); i <= top; ++i)
        sum += std::ldexp(static_cast<long double>(magnitude.words_[static_cast<std::size_t>(i)]),
                          64 * i + kLowestExponent);
    return s > 0 ? sum : -sum;
}

void addDeterminant(ExactSum& sum, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    sum.add(a.x, b.y, c.z);
    sum.add(a.y, b.z, c.x);
    sum.add(a.z, b.x, c.y);
    sum.subtract(a.x, b.z, c.y);
    sum.subtract(a.y, b.x, c.z);
    sum.subtract(a.z, b.y, c.x);
}

ExactSum signedVolume(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& p) {
    // (b − a) · ((c − a) × (p − a)), multiplied out.
    ExactSum sum;
    addDeterminant(sum, b, c, p);
    addDeterminant(sum, -a, c, p);
    addDeterminant(sum, b, -a, p);
    addDeterminant(sum, b, c, -a);
    return sum;
}

}  // namespace rayscope::measure
