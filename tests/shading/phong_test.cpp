#include "shading/phong.h"

#include <gtest/gtest.h>

#include <random>

namespace rayscope {
namespace {

glm::dvec3 onHemisphere(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const glm::dvec3 d = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    return {d.x, d.y, std::abs(d.z)};
}

/// Against long double, over the range of shininess.
TEST(Phong, IsAccurateForEveryShininess) {
    std::mt19937 random(1);
    const glm::dvec3 n(0, 0, 1);
    for (const double shininess : {0.0, 1e-3, 1.0, 32.0, 1e3, 1e6}) {
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 l = onHemisphere(random);
            // Also near the mirror direction, where high powers are not negligible.
            glm::dvec3 v = i % 2 ? onHemisphere(random)
                                 : glm::normalize(glm::dvec3(-l.x, -l.y, l.z) + 1e-3 * onHemisphere(random));
            const long double along = -static_cast<long double>(l.x) * static_cast<long double>(v.x) -
                                      static_cast<long double>(l.y) * static_cast<long double>(v.y) +
                                      static_cast<long double>(l.z) * static_cast<long double>(v.z);
            const auto exact =
                static_cast<double>(std::pow(std::max(0.0L, along), static_cast<long double>(shininess)));
            const double value = shading::phong({glm::dvec3(0), glm::dvec3(1), shininess}, n, l, v).x;
            EXPECT_NEAR(value, exact, 1e-9 * exact + 1e-30) << shininess;
        }
    }
}

TEST(Phong, IsZeroForLightBelowTheSurface) {
    const shading::PhongSurface surface{glm::dvec3(1), glm::dvec3(1), 0.0};
    const glm::dvec3 n(0, 0, 1), v = glm::normalize(glm::dvec3(1, 0, 1));
    EXPECT_EQ(shading::phong(surface, n, glm::normalize(glm::dvec3(1, 0, -1e-9)), v), glm::dvec3(0));
    EXPECT_EQ(shading::phong(surface, n, {1, 0, 0}, v), glm::dvec3(0));
    EXPECT_GT(shading::phong(surface, n, glm::normalize(glm::dvec3(1, 0, 1e-9)), v).x, 0.99);
}

TEST(Phong, IsReciprocalUpToTheCosine) {
    std::mt19937 random(2);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 l = onHemisphere(random), v = onHemisphere(random);
        const shading::PhongSurface shiny{glm::dvec3(0), glm::dvec3(1), 7.0};
        EXPECT_NEAR(shading::phong(shiny, {0, 0, 1}, l, v).x, shading::phong(shiny, {0, 0, 1}, v, l).x,
                    1e-14);
    }
}

TEST(Mirror, KeepsLengthAndChangesTheSide) {
    std::mt19937 random(3);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 n = onHemisphere(random), d = onHemisphere(random), r = shading::mirror(d, n);
        EXPECT_NEAR(glm::dot(r, n), -glm::dot(d, n), 1e-14);
        EXPECT_NEAR(glm::length(r), 1.0, 1e-14);
        EXPECT_LT(glm::distance(shading::mirror(r, n), d), 1e-14);
    }
}

}  // namespace
}  // namespace rayscope
