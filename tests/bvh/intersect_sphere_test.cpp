#include "bvh/intersect/intersect_sphere.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bvh/intersect/hit_error.h"
#include "bvh/meshes.h"

namespace rayscope::test {
namespace {

__extension__ using Quad = __float128;

Quad squareRoot(Quad x) {
    Quad root = std::sqrt(static_cast<double>(x));
    for (int i = 0; i < 3 && root != 0; ++i) root = (root + x / root) / 2;
    return root;
}

/// 113 bits are enough: with floats as input, the cancellation of the discriminant is far smaller.
struct QuadSphere {
    Quad discriminant, near, far;

    QuadSphere(const Ray& ray, const Sphere& sphere) {
        Quad f[3], a = 0, b = 0, c = -static_cast<Quad>(sphere.radius) * sphere.radius;
        for (int i = 0; i < 3; ++i) {
            f[i] = static_cast<Quad>(ray.origin[i]) - sphere.center[i];
            a += static_cast<Quad>(ray.direction[i]) * ray.direction[i];
            b -= f[i] * ray.direction[i];
            c += f[i] * f[i];
        }
        discriminant = (b * b - a * c) / a;  // radius² − distance² of the line from the center
        if (discriminant < 0) return;
        near = (b - squareRoot(a * (discriminant))) / a;
        far = (b + squareRoot(a * (discriminant))) / a;
    }
};

TEST(IntersectSphere, AgreesWithQuadruplePrecision) {
    Random random(1);
    int hits = 0, misses = 0;
    double worst = 0.0;  // error over bound
    for (const double radius : {1e-6, 1e-3, 1.0, 1e3, 1e6})
        for (const double distance : {1e-3, 0.5, 10.0, 1e3, 1e5, 1e7})
            for (int i = 0; i < 3000; ++i) {
                Sphere sphere{glm::vec3(radius * glm::dvec3(random.inCube())), static_cast<float>(radius)};
                const glm::dvec3 outward = random.onSphere();
                const glm::dvec3 side = glm::normalize(glm::cross(outward, random.onSphere()));
                Ray ray;
                ray.origin = glm::vec3(glm::dvec3(sphere.center) + radius * (1.0 + distance) * outward);
                const double edge = std::pow(10.0, random.real(-6, -0.3)) * (random.integer(2) ? 1 : -1);
                const double impact = random.integer(2) ? random.real(0, 1.2) : 1.0 + edge;
                const glm::dvec3 target = glm::dvec3(sphere.center) + radius * impact * side;
                ray.direction = glm::vec3(target - glm::dvec3(ray.origin));
                const QuadSphere exact(ray, sphere);
                // Bound of the error in double, in units of radius²: the line is computed to 2^-52 of its
                // distance.
                const double errorBound = 0x1p-50 * (2.0 + distance);
                if (std::abs(static_cast<double>(exact.discriminant)) < errorBound * radius * radius)
                    continue;
                double near, far;
                ASSERT_EQ(bvh::intersectSphere(ray, sphere, near, far), exact.discriminant > 0) << text(ray);
                ++(exact.discriminant > 0 ? hits : misses);
                if (exact.discriminant < 0) continue;
                const double bound = bvh::sphereHitError(ray, sphere);
                const double error = std::max(std::abs(static_cast<double>(near - exact.near)),
                                              std::abs(static_cast<double>(far - exact.far)));
                ASSERT_LE(error, bound) << text(ray);
                worst = std::max(worst, error / bound);
            }
    EXPECT_GT(hits, 20000);
    EXPECT_GT(misses, 10000);
    EXPECT_GE(worst, 0.01) << "the bound is not needlessly large";
    std::printf("worst error of a sphere's roots over its bound: %.3f\n", worst);
}

TEST(IntersectSphere, FirstRootInsideTheInterval) {
    const Sphere sphere{{0, 0, 0}, 1.0f};
    const Ray ray{{0, 0, -3}, {0, 0, 1}};
    double t;
    ASSERT_TRUE(bvh::intersectSphere(ray, sphere, 0.0f, 9.0f, t));
    EXPECT_EQ(t, 2.0);
    ASSERT_TRUE(bvh::intersectSphere(ray, sphere, 2.0f, 9.0f, t));
    EXPECT_EQ(t, 4.0);
    ASSERT_TRUE(bvh::intersectSphere(ray, sphere, std::nextafter(2.0f, 0.0f), 2.0f, t));
    EXPECT_EQ(t, 2.0);
    EXPECT_FALSE(bvh::intersectSphere(ray, sphere, 2.0f, std::nextafter(4.0f, 0.0f), t));
    EXPECT_FALSE(bvh::intersectSphere(ray, sphere, 4.0f, 9.0f, t));
    ASSERT_TRUE(bvh::intersectSphere({{0, 0, 0}, {0, 0, 2}}, sphere, 0.0f, 9.0f, t));
    EXPECT_EQ(t, 0.5);
}

TEST(IntersectSphere, TangentsAndTheCenter) {
    double near, far;
    ASSERT_TRUE(bvh::intersectSphere({{1, 0, -5}, {0, 0, 1}}, {{0, 0, 0}, 1}, near, far));
    EXPECT_DOUBLE_EQ(near, 5.0);
    EXPECT_DOUBLE_EQ(far, 5.0);
    ASSERT_TRUE(bvh::intersectSphere({{1, 0, 0}, {0, 0, 1}}, {{0, 0, 0}, 1}, near, far));
    EXPECT_EQ(near, 0.0);
    EXPECT_EQ(far, 0.0);
    EXPECT_FALSE(
        bvh::intersectSphere({{std::nextafter(1.0f, 2.0f), 0, -5}, {0, 0, 1}}, {{0, 0, 0}, 1}, near, far));
    ASSERT_TRUE(bvh::intersectSphere({{3, 2, 1}, {0, 3, 0}}, {{3, 2, 1}, 6}, near, far));
    EXPECT_EQ(near, -2.0);
    EXPECT_EQ(far, 2.0);
}

TEST(IntersectSphere, NonPositiveRadiusIsMissed) {
    double near, far;
    for (const float radius : {0.0f, -0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::infinity()})
        EXPECT_FALSE(bvh::intersectSphere({{0, 0, -5}, {0, 0, 1}}, {{0, 0, 0}, radius}, near, far)) << radius;
}

}  // namespace
}  // namespace rayscope::test
