#include "bvh/layout/statistics.h"

#include <gtest/gtest.h>

#include "bvh/builders/build.h"
#include "bvh/meshes.h"
#include "bvh/traversal/traversal_counts.h"

namespace rayscope::test {
namespace {

TEST(Statistics, TreeComputedByHand) {
    bvh::BinaryTree tree;  // a cube of side 2, halved; the right half is halved again
    tree.nodes = {{{0, 0, 0}, 1, {2, 2, 2}, 0},
                  {{0, 0, 0}, 0, {1, 2, 2}, 3},
                  {{1, 0, 0}, 3, {2, 2, 2}, 0},
                  {{1, 0, 0}, 3, {2, 1, 2}, 1},
                  {{1, 1, 0}, 4, {2, 2, 2}, 1}};
    tree.primitives = {0, 1, 2, 3, 4};
    tree.levels = 3;
    const bvh::TreeStatistics statistics = bvh::statisticsOf(tree);
    // Half areas: 12, 8, 8, 5, 5.
    EXPECT_DOUBLE_EQ(statistics.sahCost, 1.0 + 8.0 / 12.0 * 3.0 + 8.0 / 12.0 + 2.0 * 5.0 / 12.0);
    EXPECT_EQ(statistics.nodes, 5u);
    EXPECT_EQ(statistics.leaves, 3u);
    EXPECT_EQ(statistics.primitives, 5u);
    EXPECT_EQ(statistics.levels, 3);
    EXPECT_EQ(statistics.bytes, 5 * 32u + 5 * 4u);
    EXPECT_EQ(statistics.leavesAtLevel, (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(statistics.leavesOfSize, (std::vector<std::size_t>{0, 2, 0, 1}));
}

TEST(Statistics, EmptyTree) {
    const bvh::TreeStatistics statistics = bvh::statisticsOf({});
    EXPECT_EQ(statistics.sahCost, 0.0);
    EXPECT_EQ(statistics.leaves, 0u);
}

TEST(Statistics, BetterBuildersCostLess) {
    const TestGeometry scene = soup(20000, 0.1, 3);
    const auto cost = [&](BvhBuilder builder) {
        BuildSettings settings;
        settings.builder = builder;
        settings.keepBinaryTree = true;
        return bvh::statisticsOf(bvh::buildBinaryTree(scene.input(), settings)).sahCost;
    };
    const double median = cost(BvhBuilder::Median), sweep = cost(BvhBuilder::Sah),
                 binned = cost(BvhBuilder::SahBinned);
    EXPECT_LT(sweep, 0.9 * median);
    EXPECT_LT(binned, 0.9 * median);
    EXPECT_NEAR(binned, sweep, 0.1 * sweep);
}

/// Long thin diagonal triangles: their boxes are large and overlap.
TestGeometry needles(int count) {
    TestGeometry scene;
    Random random(5);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 at = random.inCube();
        scene.addTriangle(at, at + random.inCube(1.0), at + random.inCube(0.002));
    }
    return scene;
}

/// The number of nodes that rays through the scene visit.
std::size_t visits(const bvh::BinaryTree& tree, const TestGeometry& scene) {
    bvh::TraversalCounts counts;
    Random random(8);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 from = random.inCube(3.0), to = random.inCube();
        bvh::countTraversal(tree, scene.input(), {from, to - from}, false, counts);
    }
    return counts.nodes + counts.leaves;
}

TEST(Statistics, ReinsertionSavesAreaAndVisits) {
    for (const auto& [scene, most] :
         {std::pair{needles(4000), 0.92}, {soup(20000, 0.1, 3), 0.97}, {icosphere(5, 0.1, 2), 0.99}}) {
        BuildSettings settings;
        settings.keepBinaryTree = true;
        const bvh::BinaryTree binned = bvh::buildBinaryTree(scene.input(), settings);
        settings.builder = BvhBuilder::SahReinsertion;
        const bvh::BinaryTree high = bvh::buildBinaryTree(scene.input(), settings);
        EXPECT_LT(bvh::statisticsOf(high).sahCost, most * bvh::statisticsOf(binned).sahCost) << scene.name;
        EXPECT_LT(visits(high, scene), visits(binned, scene)) << scene.name;
    }
}

TEST(Statistics, ReinsertionNeverCostsMore) {
    for (const TestGeometry& scene : edgeCaseScenes())
        for (const int leafSize : {1, 4, 16})
            for (const int maxLevel : {2, 64}) {
                BuildSettings settings;
                settings.keepBinaryTree = true;
                settings.leafSize = leafSize;
                settings.maxLevel = maxLevel;
                const double binned =
                    bvh::statisticsOf(bvh::buildBinaryTree(scene.input(), settings)).sahCost;
                settings.builder = BvhBuilder::SahReinsertion;
                const double high = bvh::statisticsOf(bvh::buildBinaryTree(scene.input(), settings)).sahCost;
                EXPECT_LE(high, binned * (1.0 + 1e-5)) << scene.name << " " << leafSize << " " << maxLevel;
            }
}

}  // namespace
}  // namespace rayscope::test
