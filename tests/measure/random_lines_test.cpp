#include "measure/bench/random_lines.h"

#include <gtest/gtest.h>

#include "bvh/builders/build.h"
#include "bvh/layout/statistics.h"
#include "bvh/meshes.h"

namespace rayscope::test {
namespace {

TEST(RandomLines, HaveTheSahCostOnAverage) {
    const TestGeometry scene = soup(3000, 0.1, 3);
    for (const BvhBuilder builder : {BvhBuilder::Median, BvhBuilder::SahBinned}) {
        BuildSettings settings;
        settings.builder = builder;
        const bvh::BinaryTree tree = bvh::buildBinaryTree(scene.input(), settings);
        EXPECT_NEAR(measure::costOfRandomLines(tree, 20000) / bvh::statisticsOf(tree).sahCost, 1.0, 0.02);
    }
}

TEST(RandomLines, HaveTheExactCostInSmallTrees) {
    EXPECT_EQ(measure::costOfRandomLines({}, 10), 0.0);
    bvh::BinaryTree leaf;
    leaf.nodes = {{{0, 0, 0}, 0, {1, 2, 3}, 5}};
    EXPECT_EQ(measure::costOfRandomLines(leaf, 100), 5.0) << "every line intersects the root";
    bvh::BinaryTree halves;  // a flat box: each line intersects one of its halves
    halves.nodes = {{{0, 0, 0}, 1, {2, 2, 0}, 0}, {{0, 0, 0}, 0, {1, 2, 0}, 4}, {{1, 0, 0}, 4, {2, 2, 0}, 4}};
    EXPECT_NEAR(measure::costOfRandomLines(halves, 1000), 5.0, 0.1);
}

}  // namespace
}  // namespace rayscope::test
