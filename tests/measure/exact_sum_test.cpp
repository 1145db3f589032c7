#include "measure/lab/exact_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace rayscope::test {
namespace {

__extension__ using Int = __int128;

constexpr float kLeast = std::numeric_limits<float>::denorm_min(),
                kLargest = std::numeric_limits<float>::max();

int signOf(Int x) { return (x > 0) - (x < 0); }

TEST(ExactSum, SumsProductsOfTheSmallestAndTheLargestFloats) {
    measure::ExactSum sum;
    sum.add(kLargest, kLargest, kLargest);
    sum.add(kLeast, -kLeast, kLeast);
    EXPECT_EQ(sum.sign(), 1);
    sum.subtract(kLargest, kLargest, kLargest);
    EXPECT_EQ(sum.sign(), -1);
    EXPECT_EQ(sum.value(), -std::ldexp(1.0L, -447));
    sum.add(-kLeast, -kLeast, kLeast);
    EXPECT_EQ(sum.sign(), 0);
    EXPECT_EQ(sum.value(), 0.0L);
}

/// Products of floats with integer values fit into 128 bits, so the expected sum is exact.
TEST(ExactSum, AgreesWithIntegers) {
    std::mt19937_64 random(1);
    const auto integer = [&] {
        return static_cast<std::int64_t>(random() >> 40) * (random() & 1 ? 1 : -1);  // 24 bits
    };
    for (int i = 0; i < 20000; ++i) {
        measure::ExactSum sum;
        Int expected = 0;
        const int terms = static_cast<int>(random() % 20);
        // Scaled by powers of two that cancel.
        const int shift = static_cast<int>(random() % 100) - 50;
        for (int k = 0; k < terms; ++k) {
            const std::int64_t a = integer(), b = integer(), c = random() % 4 ? integer() : 1;
            sum.add(std::ldexp(static_cast<float>(a), shift), static_cast<float>(b),
                    std::ldexp(static_cast<float>(c), -shift));
            expected += Int{a} * b * c;
            if (random() % 3 == 0) {  // cancels the last product except for one unit
                sum.subtract(static_cast<float>(a), static_cast<float>(b), static_cast<float>(c));
                sum.add(1.0f, 1.0f);
                expected += 1 - Int{a} * b * c;
            }
        }
        ASSERT_EQ(sum.sign(), signOf(expected));
        const auto value = static_cast<long double>(expected);
        ASSERT_LE(std::abs(sum.value() - value), 0x1p-60L * std::abs(value));
        measure::ExactSum twice = sum;
        twice += sum;
        ASSERT_EQ(twice.value(), 2.0L * sum.value());
        twice += -sum;
        twice += -sum;
        ASSERT_EQ(twice.sign(), 0);
    }
}

TEST(ExactSum, SignedVolumesHaveTheCorrectSign) {
    std::mt19937_64 random(2);
    const auto point = [&] {
        const auto coordinate = [&] { return static_cast<int>(random() % 7) - 3; };
        return glm::ivec3(coordinate(), coordinate(), coordinate());
    };
    int flat = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::ivec3 a = point(), b = point(), c = point(), p = point();
        const glm::dvec3 normal = glm::cross(glm::dvec3(b - a), glm::dvec3(c - a));
        const double expected = glm::dot(normal, glm::dvec3(p - a));  // small integers: exact
        const float s = std::ldexp(1.0f, static_cast<int>(random() % 200) - 100);
        const measure::ExactSum volume =
            measure::signedVolume(s * glm::vec3(a), s * glm::vec3(b), s * glm::vec3(c), s * glm::vec3(p));
        ASSERT_EQ(volume.sign(), (expected > 0.0) - (expected < 0.0));
        flat += volume.sign() == 0;
    }
    EXPECT_GT(flat, 1000);
}

}  // namespace
}  // namespace rayscope::test
