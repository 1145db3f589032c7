#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

#include "bvh/binary_tree.h"
#include "bvh/meshes.h"

namespace rayscope::test {
namespace {

const Ray kRay{{0.25f, 0.25f, -1}, {0, 0, 1}};

TestGeometry oneTriangle() {
    TestGeometry geometry;
    geometry.addTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    return geometry;
}

void expectEmpty(const Accel& accel) {
    Hit hit{1, 2, 3, 4};
    EXPECT_FALSE(accel.closestHit(kRay, hit));
    EXPECT_TRUE(sameHit(hit, Hit{}));
    EXPECT_FALSE(accel.anyHit(kRay));
    std::vector<Hit> hits(3, Hit{1, 2, 3, 4});
    std::vector<std::uint8_t> occluded(3, 1);
    const std::vector<Ray> rays(3, kRay);
    accel.closestHits(rays, hits);
    accel.anyHits(rays, occluded);
    for (const Hit& each : hits) EXPECT_TRUE(sameHit(each, Hit{}));
    EXPECT_EQ(occluded, std::vector<std::uint8_t>(3, 0));
    EXPECT_EQ(accel.binaryTree(), nullptr);
    EXPECT_TRUE(accel.input().triangles.empty());
}

TEST(Accel, EveryRayMissesTheDefault) {
    expectEmpty(Accel{});
    EXPECT_EQ(Accel{}.bytes(), 0u);
}

TEST(Accel, BuildWithoutPrimitivesIsEmpty) { expectEmpty(Accel::build({})); }

TEST(Accel, MovedFromIsEmptyAndMovedToIsWhole) {
    const TestGeometry geometry = oneTriangle();
    Accel first = Accel::build(geometry.input());
    Accel second = std::move(first);
    expectEmpty(first);
    Hit hit;
    ASSERT_TRUE(second.closestHit(kRay, hit));
    EXPECT_TRUE(sameHit(hit, {1.0f, 0, 0.25f, 0.25f}));
    first = std::move(second);
    expectEmpty(second);
    EXPECT_TRUE(first.anyHit(kRay));
    EXPECT_GT(first.bytes(), 0u);
    EXPECT_EQ(first.input().triangles.size(), 1u);
}

TEST(Accel, SpheresCountAfterTriangles) {
    TestGeometry geometry = oneTriangle();
    geometry.spheres = {{{0.25f, 0.25f, 5}, 1.0f}, {{0.25f, 0.25f, -0.5f}, 0.25f}};
    const Accel accel = Accel::build(geometry.input());
    Hit hit;
    ASSERT_TRUE(accel.closestHit(kRay, hit));
    EXPECT_TRUE(sameHit(hit, {0.25f, 2, 0, 0}));
    ASSERT_TRUE(accel.closestHit({kRay.origin, kRay.direction, 1.0f, 9.0f}, hit));
    EXPECT_TRUE(sameHit(hit, {5.0f, 1, 0, 0}));
}

TEST(Accel, InvalidArgumentsThrow) {
    const TestGeometry geometry = oneTriangle();
    const Accel accel = Accel::build(geometry.input());
    const std::vector<Ray> rays(1000, kRay);
    std::vector<Hit> hits(10);
    std::vector<std::uint8_t> occluded(2000);
    for (const Accel* tested : {&accel, &static_cast<const Accel&>(Accel())}) {
        EXPECT_THROW(tested->closestHits(rays, hits), std::invalid_argument);
        EXPECT_THROW(tested->anyHits(rays, occluded), std::invalid_argument);
        EXPECT_NO_THROW(tested->closestHits({}, {}));
    }
    EXPECT_THROW(Accel::build(geometry.input(), {.builder = static_cast<BvhBuilder>(99)}),
                 std::invalid_argument);
    EXPECT_THROW(Accel::build(geometry.input(), {.layout = static_cast<BvhLayout>(99)}),
                 std::invalid_argument);
    EXPECT_THROW(Accel::build(geometry.input(), {.isa = static_cast<Isa>(-1)}), std::invalid_argument);
}

}  // namespace
}  // namespace rayscope::test
