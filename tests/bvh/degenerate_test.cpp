// A million degenerate primitives: builds end, and hits are correct.
#include <gtest/gtest.h>

#include <cmath>

#include "bvh/binary_tree.h"
#include "bvh/isa.h"
#include "bvh/meshes.h"

namespace rayscope::test {
namespace {

#ifdef NDEBUG
constexpr int kMany = 1'000'000;
#else  // with sanitizers
constexpr int kMany = 100'000;
#endif

/// Nested boxes with a common center.
TestGeometry nested(int count) {
    TestGeometry geometry;
    for (int i = 1; i <= count; ++i) {
        const float r = static_cast<float>(i) / static_cast<float>(count);
        geometry.addTriangle({-r, -r, -r}, {r, r, r}, {r, -r, r});
    }
    return geometry;
}

/// Copies of one triangle.
TestGeometry copies(int count) {
    TestGeometry geometry;
    geometry.vertices = {{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}};
    geometry.triangles.assign(static_cast<std::size_t>(count), {0, 1, 2});
    return geometry;
}

/// Triangles without area in one point, and a regular one behind it.
TestGeometry onePoint(int count) {
    TestGeometry geometry;
    geometry.vertices = {{0.25f, 0.25f, 0.25f}};
    geometry.triangles.assign(static_cast<std::size_t>(count), {0, 0, 0});
    geometry.addTriangle({-1, -1, 0}, {2, -1, 0}, {-1, 2, 0});
    return geometry;
}

Accel built(const TestGeometry& geometry, BvhBuilder builder) {
    BuildSettings settings;
    settings.builder = builder;
    settings.keepBinaryTree = true;
    Accel accel = Accel::build(geometry.input(), settings);
    EXPECT_LE(accel.summary().binaryLevels, settings.maxLevel + 1);
    return accel;
}

class Degenerate : public testing::TestWithParam<BvhBuilder> {
  protected:
    /// SAH sweep and reinsertion are slower than the binned builder; a tenth of the triangles suffices for
    /// the others.
    int count() const { return GetParam() == BvhBuilder::SahBinned ? kMany : kMany / 10; }
};

TEST_P(Degenerate, NestedBoxes) {
    const TestGeometry geometry = nested(count());
    const Accel accel = built(geometry, GetParam());
    // From within all of them, or from outside: all triangles lie in the plane x = z.
    for (const float y : {-0.5f, -0.25f, 0.1f}) {
        Hit hit;
        ASSERT_TRUE(accel.closestHit({{1, y, 0}, {-1, 0, 1}}, hit)) << y;
        EXPECT_EQ(hit.t, 0.5f);
        // The least of those that reach there: their corner (r, −r, r) and their side from (−r, −r) to (r,
        // r).
        const TestGeometry one{"",
                               {geometry.corner(hit.primitive, 0), geometry.corner(hit.primitive, 1),
                                geometry.corner(hit.primitive, 2)},
                               {{0, 1, 2}},
                               {}};
        EXPECT_TRUE(Accel::build(one.input()).anyHit({{1, y, 0}, {-1, 0, 1}}));
        if (hit.primitive > 0) {
            const std::size_t before = hit.primitive - 1;
            const TestGeometry smaller{
                "",
                {geometry.corner(before, 0), geometry.corner(before, 1), geometry.corner(before, 2)},
                {{0, 1, 2}},
                {}};
            EXPECT_FALSE(Accel::build(smaller.input()).anyHit({{1, y, 0}, {-1, 0, 1}}));
        }
    }
    EXPECT_FALSE(accel.anyHit({{2, 2, 2}, {0, 0, 1}}));
}

TEST_P(Degenerate, CopiesOfOneTriangle) {
    const TestGeometry geometry = copies(count());
    const Accel accel = built(geometry, GetParam());
    Hit hit;
    ASSERT_TRUE(accel.closestHit({{0, 0, 3}, {0, 0, -1}}, hit));
    EXPECT_EQ(hit.t, 3.0f);
    EXPECT_EQ(hit.primitive, 0u);
    EXPECT_FALSE(accel.anyHit({{5, 0, 3}, {0, 0, -1}}));
}

TEST_P(Degenerate, TrianglesInOnePoint) {
    const TestGeometry geometry = onePoint(count());
    const Accel accel = built(geometry, GetParam());
    Hit hit;
    ASSERT_TRUE(accel.closestHit({{0.25f, 0.25f, 3}, {0, 0, -1}}, hit));
    EXPECT_EQ(hit.t, 3.0f);
    EXPECT_EQ(hit.primitive, static_cast<std::uint32_t>(count()));
}

/// Half of a floor that extends behind the origin of the ray, which hits its edge: depths times edge
/// functions overflow in float long before edge functions do.
TEST(Huge, TrianglesBehindTheOriginAreHit) {
    for (int exponent = -60; exponent <= 60; ++exponent) {
        const float s = std::ldexp(1.0f, exponent);
        TestGeometry floor;
        floor.addTriangle(s * glm::vec3(-20.0f, -0x1.99999ap-2f, 20.0f),
                          s * glm::vec3(20.0f, -0x1.99999ap-2f, -20.0f),
                          s * glm::vec3(-20.0f, -0x1.99999ap-2f, -20.0f));
        const Ray ray{s * glm::vec3(-0x1.59289p-1f, 0x1.c71e84p+2f, -0x1.2ed3f6p-1f),
                      {-0x1.425be8p-1f, -0x1.6df9cp-2f, 0x1.6130fcp-1f}};
        for (const Isa isa : {Isa::Scalar, Isa::Sse2, Isa::Avx2, Isa::Avx512}) {
            if (!bvh::isAvailable(isa)) continue;
            BuildSettings settings;
            settings.isa = isa;
            Hit hit;
            EXPECT_TRUE(Accel::build(floor.input(), settings).closestHit(ray, hit))
                << "size 2^" << exponent << ", isa " << static_cast<int>(isa);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Builders, Degenerate,
                         testing::Values(BvhBuilder::Median, BvhBuilder::Sah, BvhBuilder::SahBinned,
                                         BvhBuilder::SahReinsertion),
                         [](const auto& builder) {
                             return std::string(builder.param == BvhBuilder::Median           ? "Median"
                                                : builder.param == BvhBuilder::Sah            ? "Sweep"
                                                : builder.param == BvhBuilder::SahReinsertion ? "High"
                                                                                              : "Binned");
                         });

}  // namespace
}  // namespace rayscope::test
