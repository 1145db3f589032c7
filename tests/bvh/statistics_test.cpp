#include "bvh/statistics.h"

#include <gtest/gtest.h>

#include "bvh/build.h"
#include "bvh/meshes.h"

namespace rayscope::test {
namespace {

TEST(Statistics, OfATreeComputedByHand) {
    BinaryTree tree;  // a cube of side 2, halved; the right half is halved again
    tree.nodes = {{{0, 0, 0}, 1, {2, 2, 2}, 0},
                  {{0, 0, 0}, 0, {1, 2, 2}, 3},
                  {{1, 0, 0}, 3, {2, 2, 2}, 0},
                  {{1, 0, 0}, 3, {2, 1, 2}, 1},
                  {{1, 1, 0}, 4, {2, 2, 2}, 1}};
    tree.primitives = {0, 1, 2, 3, 4};
    tree.levels = 3;
    const TreeStatistics statistics = statisticsOf(tree);
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

TEST(Statistics, OfNothing) {
    const TreeStatistics statistics = statisticsOf({});
    EXPECT_EQ(statistics.sahCost, 0.0);
    EXPECT_EQ(statistics.leaves, 0u);
}

TEST(Statistics, BetterBuildersCostLess) {
    const Geometry scene = soup(20000, 0.1, 3);
    const auto cost = [&](BvhBuilder builder) {
        BuildSettings settings;
        settings.builder = builder;
        return statisticsOf(buildBinaryTree(scene.input(), settings)).sahCost;
    };
    const double median = cost(BvhBuilder::Median), sweep = cost(BvhBuilder::Sah),
                 binned = cost(BvhBuilder::SahBinned);
    EXPECT_LT(sweep, 0.9 * median);
    EXPECT_LT(binned, 0.9 * median);
    EXPECT_NEAR(binned, sweep, 0.1 * sweep);
}

}  // namespace
}  // namespace rayscope::test
