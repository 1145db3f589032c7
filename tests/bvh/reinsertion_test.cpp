// Reinsertion: gains are as computed, and no better target exists.
#include "bvh/builders/reinsertion.h"

#include <gtest/gtest.h>

#include "bvh/builders/build.h"
#include "bvh/meshes.h"

namespace rayscope::test {
namespace {

bvh::BinaryTree treeOf(const TestGeometry& scene, BvhBuilder builder) {
    BuildSettings settings;
    settings.builder = builder;
    settings.leafSize = 1;
    return bvh::buildBinaryTree(scene.input(), settings);
}

/// Checks boxes and links from `node` down; returns the area of all inner nodes there. `levels` becomes the
/// deepest level.
double checkedArea(const bvh::LinkedTree& tree, std::uint32_t node, int level, int& levels,
                   std::size_t& nodes) {
    ++nodes;
    levels = std::max(levels, level);
    if (tree[node].isLeaf()) return 0.0;
    bvh::Bounds4 box;
    double area = 0.0;
    for (const std::uint32_t child : {tree[node].left, tree[node].right}) {
        EXPECT_EQ(tree.parent(child), node);
        box.extend(tree[child].box());
        area += checkedArea(tree, child, level + 1, levels, nodes);
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(tree[node].lower[axis], box.lower[axis]);
        EXPECT_EQ(tree[node].upper[axis], box.upper[axis]);
    }
    return area + static_cast<double>(box.halfArea(tree.scale()));
}

double checkedArea(const bvh::LinkedTree& tree, int mostLevels = bvh::kMaxTreeLevel) {
    int levels = 0;
    std::size_t nodes = 0;
    const double area = checkedArea(tree, tree.root(), 0, levels, nodes);
    EXPECT_EQ(tree.parent(tree.root()), bvh::kNoNode);
    EXPECT_EQ(nodes, tree.size());
    EXPECT_LE(levels, mostLevels);
    return area;
}

TEST(Reinsertion, FindsTheBestTarget) {
    int found = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const TestGeometry scene = soup(40, 0.7, seed);
        const bvh::LinkedTree tree(treeOf(scene, BvhBuilder::Median), 1.0f, {});
        for (std::uint32_t node = 0; node < tree.size(); ++node) {
            double best = 0.0;
            for (std::uint32_t target = 0; target < tree.size(); ++target) {
                bvh::LinkedTree copy = tree;
                best = std::max(best, copy.moveIfBetter(node, target, bvh::kMaxTreeLevel));
            }
            const bvh::Reinsertion move = bvh::bestReinsertion(tree, node);
            ASSERT_NEAR(static_cast<double>(move.gain), best, 1e-5) << "seed " << seed << ", node " << node;
            if (move.target == bvh::kNoNode) continue;
            bvh::LinkedTree copy = tree;
            ASSERT_NEAR(copy.moveIfBetter(node, move.target, bvh::kMaxTreeLevel), best, 1e-5);
            ++found;
        }
    }
    EXPECT_GT(found, 100);
}

TEST(Reinsertion, GainsAreAsComputed) {
    bvh::LinkedTree tree(treeOf(soup(500, 0.4, 7), BvhBuilder::Median), 1.0f, {});
    Random random(3);
    double area = checkedArea(tree);
    int made = 0, refused = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto node = static_cast<std::uint32_t>(random.integer(static_cast<int>(tree.size())));
        const auto other = static_cast<std::uint32_t>(random.integer(static_cast<int>(tree.size())));
        const bvh::Reinsertion best = bvh::bestReinsertion(tree, node);
        const std::uint32_t target = best.target == bvh::kNoNode || i % 2 ? other : best.target;
        const double gain = tree.moveIfBetter(node, target, bvh::kMaxTreeLevel);
        ASSERT_GE(gain, 0.0);
        gain > 0.0 ? ++made : ++refused;
        const double after = checkedArea(tree);
        ASSERT_NEAR(area - after, gain, 1e-4);
        area = after;
    }
    EXPECT_GT(made, 100);
    EXPECT_GT(refused, 100);
}

TEST(Reinsertion, RespectsTheDeepestLevel) {
    const bvh::BinaryTree source = treeOf(soup(300, 0.4, 9), BvhBuilder::Median);
    const int limit = source.levels - 1;
    bvh::LinkedTree bounded(source, 1.0f, {}), free(source, 1.0f, {});
    int refused = 0;
    for (int round = 0; round < 5; ++round)
        for (std::uint32_t node = 0; node < bounded.size(); ++node) {
            const bvh::Reinsertion move = bvh::bestReinsertion(bounded, node);
            if (move.target != bvh::kNoNode) refused += bounded.moveIfBetter(node, move.target, limit) == 0.0;
            const bvh::Reinsertion freeMove = bvh::bestReinsertion(free, node);
            if (freeMove.target != bvh::kNoNode) free.moveIfBetter(node, freeMove.target, bvh::kMaxTreeLevel);
        }
    EXPECT_LT(checkedArea(free), checkedArea(bounded, limit));
    EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace rayscope::test
