// The SAH costs of all split planes, and the traversal cost of trees.
#include <gtest/gtest.h>

#include <cmath>

#include "bvh/builders/build.h"
#include "bvh/layout/statistics.h"
#include "probe/split_curve.h"
#include "probe/traversal_costs.h"
#include "probe/tree_index.h"
#include "support/test_scenes.h"

namespace rayscope {
namespace {

double lowest(const probe::SplitCurve& curve) {
    double best = std::numeric_limits<double>::infinity();
    for (const auto& planes : curve.axes)
        for (const auto& plane : planes)
            if (plane.cost < best) best = plane.cost;
    return best;
}

TEST(SplitCurve, TwoTrianglesComputedByHand) {
    // Two flat unit squares' halves at x = 0 and x = 8; the box is 9 × 1 × 0.
    const std::vector<glm::vec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {8, 0, 0}, {9, 0, 0}, {8, 1, 0}};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {3, 4, 5}};
    const AccelInput input{vertices, triangles, {}};
    bvh::BinaryTree tree;
    tree.nodes = {{{0, 0, 0}, 1, {9, 1, 0}, 0}, {{0, 0, 0}, 0, {1, 1, 0}, 1}, {{8, 0, 0}, 1, {9, 1, 0}, 1}};
    tree.primitives = {0, 1};
    const probe::SplitCurve curve = probe::splitCurve(tree, input, 0, 4);
    ASSERT_EQ(curve.axes[0].size(), 3u);
    EXPECT_TRUE(curve.axes[1].empty()) << "all centroids are equal";
    EXPECT_TRUE(curve.axes[2].empty());
    for (const auto& plane : curve.axes[0]) {
        EXPECT_DOUBLE_EQ(plane.cost, 1.0 + (1.0 + 1.0) / 9.0);
        EXPECT_EQ(plane.left, 1u);
    }
    EXPECT_DOUBLE_EQ(curve.axes[0][1].position, 4.5);
    EXPECT_DOUBLE_EQ(curve.leafCost, 2.0);
    EXPECT_DOUBLE_EQ(curve.actualCost, 1.0 + 2.0 / 9.0);
    EXPECT_TRUE(std::isnan(probe::splitCurve(tree, input, 1, 4).actualCost)) << "a leaf has no split";
}

TEST(SplitCurve, MinimumIsTheSplitOfTheBinnedBuilder) {
    const auto world = test::compileBuiltin("monkey", 64);
    const AccelInput& input = world->motionGroups[0].geometry->input;
    for (const int bins : {8, 32}) {
        BuildSettings settings;
        settings.bins = bins;
        const bvh::BinaryTree tree = bvh::buildBinaryTree(input, settings);
        const probe::TreeIndex index = probe::indexTree(tree);
        int compared = 0;
        for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
            // Nodes of few primitives are split with fewer bins.
            if (index.primitives[node] < 4u * 32u) continue;
            const probe::SplitCurve curve = probe::splitCurve(tree, input, node, bins);
            EXPECT_NEAR(curve.actualCost, lowest(curve), 1e-4 * curve.actualCost) << "node " << node;
            ++compared;
        }
        EXPECT_GT(compared, 5);
    }
    BuildSettings median;
    median.builder = BvhBuilder::Median;
    const bvh::BinaryTree tree = bvh::buildBinaryTree(input, median);
    const probe::SplitCurve curve = probe::splitCurve(tree, input, 0, 32);
    EXPECT_GT(curve.actualCost, lowest(curve) * 1.001) << "the median split is not the cheapest";
}

TEST(TraversalCosts, BetterTreeCostsLess) {
    const auto world = test::compileBuiltin("monkey", 64);
    const AccelInput& input = world->motionGroups[0].geometry->input;
    const probe::ViewRays rays = probe::raysOfView(*world, 0, 0, 16, 16);
    EXPECT_GE(rays.closest.size(), 256u);
    EXPECT_GT(rays.any.size(), 20u);
    BuildSettings settings;
    const probe::TraversalCosts binned =
        probe::traversalCosts(bvh::buildBinaryTree(input, settings), input, rays);
    settings.builder = BvhBuilder::Median;
    const probe::TraversalCosts median =
        probe::traversalCosts(bvh::buildBinaryTree(input, settings), input, rays);
    EXPECT_GT(binned.nodes, 1.0);
    EXPECT_LT(binned.nodes, median.nodes);
    settings.builder = BvhBuilder::SahBinned;
    settings.leafSize = 64;
    settings.maxLevel = 3;
    const probe::TraversalCosts coarse =
        probe::traversalCosts(bvh::buildBinaryTree(input, settings), input, rays);
    EXPECT_LT(coarse.nodes, binned.nodes);
    EXPECT_GT(coarse.tests, 5.0 * binned.tests);
    settings.maxLevel = 0;
    const probe::TraversalCosts all =
        probe::traversalCosts(bvh::buildBinaryTree(input, settings), input, {rays.closest, {}});
    EXPECT_LE(all.tests, static_cast<double>(input.triangles.size()));
    EXPECT_LE(all.nodes, 1.0);
}

}  // namespace
}  // namespace rayscope
