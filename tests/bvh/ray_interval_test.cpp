// Ray intervals and invalid rays, for every query.
#include <gtest/gtest.h>

#include "bvh/meshes.h"
#include "bvh/traversal_cases.h"

namespace rayscope::test {
namespace {

TEST(RayInterval, InvalidRaysMiss) {
    const TestGeometry scene = soup(100, 2.0, 2);
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(),
                    kInf = std::numeric_limits<float>::infinity();
    const std::vector<Ray> rays = {
        {{kNaN, 0, 0}, {0, 0, 1}},          {{0, 0, -9}, {0, kNaN, 1}},        {{0, 0, -9}, {0, 0, 0}},
        {{0, 0, -9}, {0, -0.0f, 0}},        {{0, 0, -9}, {0, 0, kInf}},        {{-kInf, 0, 0}, {1, 0, 0}},
        {{0, 0, -9}, {0, 0, 1}, kNaN, 9},   {{0, 0, -9}, {0, 0, 1}, 0, kNaN},  {{0, 0, -9}, {0, 0, 1}, 5, 5},
        {{0, 0, -9}, {0, 0, 1}, 20.0f, 10}, {{0, 0, -9}, {0, 0, 1}, 0, -1.0f},
    };
    for (const TraversalCase& traversalCase : traversalCases()) {
        const Accel accel = build(scene, {}, traversalCase);
        std::vector<Hit> hits(rays.size(), Hit{1, 2, 3, 4});
        std::vector<std::uint8_t> occluded(rays.size(), 7);
        accel.closestHits(rays, hits);
        accel.anyHits(rays, occluded);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            EXPECT_TRUE(sameHit(hits[i], Hit{})) << text(rays[i]);
            EXPECT_EQ(occluded[i], 0) << text(rays[i]);
        }
        for (const Ray& ray : rays) {
            Hit hit{1, 2, 3, 4};
            EXPECT_FALSE(accel.closestHit(ray, hit)) << text(ray);
            EXPECT_TRUE(sameHit(hit, Hit{})) << text(ray);
            EXPECT_FALSE(accel.anyHit(ray)) << text(ray);
        }
    }
}

TEST(RayInterval, IntervalIsOpenBelowAndClosedAbove) {
    TestGeometry scene = soup(300, 0.4, 31);
    Random random(4);
    for (int i = 0; i < 20; ++i) scene.spheres.push_back({random.inCube(), 0.1f});
    int tried = 0;
    for (const TraversalCase& traversalCase : traversalCases())
        for (const Accel accel = build(scene, {}, traversalCase); Ray ray : edgeCaseRays(scene, 3000, 8)) {
            ray.tMin = 0.0f;
            ray.tMax = std::numeric_limits<float>::infinity();
            Hit hit, again;
            if (!accel.closestHit(ray, hit)) continue;
            ++tried;
            ray.tMax = hit.t;
            ASSERT_TRUE(accel.closestHit(ray, again) && sameHit(again, hit)) << text(ray);
            ASSERT_TRUE(accel.anyHit(ray));
            ray.tMax = std::nextafter(hit.t, 0.0f);
            ASSERT_FALSE(accel.closestHit(ray, again)) << text(ray);
            ASSERT_FALSE(accel.anyHit(ray));
            ray.tMax = std::numeric_limits<float>::infinity();
            ray.tMin = std::nextafter(hit.t, 0.0f);
            ASSERT_TRUE(accel.closestHit(ray, again) && sameHit(again, hit)) << text(ray);
            ray.tMin = hit.t;
            if (accel.closestHit(ray, again)) {
                ASSERT_GT(again.t, hit.t);
            }
        }
    EXPECT_GT(tried, 1000);
}

TEST(RayInterval, DirectionScaledByAPowerOfTwoScalesOnlyT) {
    const TestGeometry scene = soup(300, 0.4, 77);
    int tried = 0;
    for (const TraversalCase& traversalCase : traversalCases())
        for (const Accel accel = build(scene, {}, traversalCase); Ray ray : edgeCaseRays(scene, 400, 12)) {
            ray.tMin = 0.0f;
            ray.tMax = std::numeric_limits<float>::infinity();
            Hit hit;
            if (!accel.closestHit(ray, hit)) continue;
            for (int k = -90; k <= 90; k += 15) {
                Ray scaled = ray;
                for (int axis = 0; axis < 3; ++axis)
                    scaled.direction[axis] = std::ldexp(ray.direction[axis], k);
                bool exact = true;  // no component became denormal
                for (int axis = 0; axis < 3; ++axis)
                    exact &= std::ldexp(scaled.direction[axis], -k) == ray.direction[axis];
                if (!exact) continue;
                Hit expected = hit, found;
                expected.t = std::ldexp(hit.t, -k);
                if (std::ldexp(expected.t, k) != hit.t) continue;
                ASSERT_TRUE(accel.closestHit(scaled, found));
                ASSERT_TRUE(sameHit(found, expected))
                    << k << " " << text(ray) << text(found) << text(expected);
                ++tried;
            }
        }
    EXPECT_GT(tried, 1000);
}

}  // namespace
}  // namespace rayscope::test
