// The float test of eight triangles excludes no hit of the exact test, and its certain hits are hits.
#include <gtest/gtest.h>

#include "bvh/intersect/ray_data.h"
#include "bvh/meshes.h"
// clang-format off: the lanes come first
#include "bvh/kernel/lanes_portable.inl"
// clang-format on
#include "bvh/kernel/intersect_block.inl"

namespace rayscope::test {
namespace {

using namespace bvh::kernel;

struct FilterCase {
    TriangleBlock block;
    Ray ray;
};

float edgeFactor(Random& random) {
    constexpr float kFactors[] = {0.0f, 0x1p-24f, -0x1p-24f, 0x1p-22f, -0x1p-22f, 1e-5f, -1e-5f, 0.01f};
    return kFactors[random.integer(8)];
}

/// Eight random triangles and a ray towards a point inside, on or near an edge of one of them; its interval
/// ends far away or within a few roundings of that point.
FilterCase edgeCase(Random& random) {
    FilterCase made{};
    const int world = random.integer(4) == 0 ? random.integer(100) - 50 : 0;
    const float size = std::ldexp(1.0f, random.integer(60) - 45),
                distance = std::ldexp(1.0f, world + random.integer(20) - 10);
    const glm::vec3 origin = random.inCube() * std::ldexp(1.0f, world + random.integer(12) - 6),
                    center = origin + distance * random.inCube();
    glm::vec3 corners[8][3];
    for (int lane = 0; lane < 8; ++lane)
        for (int corner = 0; corner < 3; ++corner) {
            corners[lane][corner] = center + size * distance * random.inCube();
            for (int axis = 0; axis < 3; ++axis)
                made.block.corner[corner][axis][lane] = corners[lane][corner][axis];
        }
    const auto& chosen = corners[random.integer(8)];
    const float v = static_cast<float>(random.real(0.0, 1.0)), w = edgeFactor(random);
    const glm::vec3 aim = chosen[0] + v * (chosen[1] - chosen[0]) + w * (chosen[2] - chosen[0]);
    // Also where t is close to the largest float.
    const int scale = random.integer(4) == 0 ? random.integer(20) - 137 : random.integer(30) - 15;
    const float end = std::ldexp(1.0f + edgeFactor(random), -scale);
    made.ray = {origin, {}, 0.0f, std::numeric_limits<float>::infinity()};
    for (int axis = 0; axis < 3; ++axis)
        made.ray.direction[axis] = std::ldexp(aim[axis] - origin[axis], scale);
    if (random.integer(3) == 0)
        made.ray.tMin = end;
    else if (random.integer(2) == 0)
        made.ray.tMax = end;
    return made;
}

TEST(FilterResult, ExcludesNoHitAndIsCertainOfHitsOnly) {
    Random random(5);
    int hits = 0, certainHits = 0, undecided = 0, tooFar = 0;
    for (int i = 0; i < 200'000; ++i) {
        const auto [block, ray] = edgeCase(random);
        const RayData data = bvh::rayData(ray);
        if (!isTraceable(data)) continue;
        FastRay fast;
        fast.prepare(data);
        if (!fast.isInRange(std::ldexp(1.0f, 60))) continue;
        FastShear shear{};
        shear.prepareOnce(data, fast.scale);
        const FilterResult found = filterTriangles(block, kBlockTag | 7u << kBlockSizeShift, shear, fast.tMin,
                                                   scaledTMax(ray.tMax, fast.scale));
        const unsigned certain = found.possible != 0 ? found.certain() : 0;
        const BlockRay exact(data, shear);
        for (int lane = 0; lane < 8; ++lane) {
            HitData hit{};
            const bool isHit = exact.hits(block, lane, ray.tMax, hit);
            const bool isPossible = (found.possible >> lane & 1u) != 0,
                       isCertain = (certain >> lane & 1u) != 0;
            ASSERT_TRUE(isPossible || !isHit) << text(ray);
            ASSERT_TRUE(isHit || !isCertain) << text(ray);
            hits += isHit;
            certainHits += isCertain;
            undecided += isPossible && !isHit;
            tooFar += !(hit.t < kInfinity);
        }
    }
    EXPECT_GT(hits, 50'000);
    EXPECT_GT(certainHits, hits / 10);
    EXPECT_GT(undecided, 1000);
    EXPECT_GT(tooFar, 100) << "the exact test rejects a t that is too large for a float";
}

}  // namespace
}  // namespace rayscope::test
