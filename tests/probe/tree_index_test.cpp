#include "probe/tree_index.h"

#include <gtest/gtest.h>

#include <numeric>

#include "bvh/builders/build.h"
#include "bvh/layout/statistics.h"
#include "support/test_scenes.h"

namespace rayscope {
namespace {

/// A cube of side 2, halved; the right half has two overlapping children.
bvh::BinaryTree handMadeTree() {
    bvh::BinaryTree tree;
    tree.nodes = {{{0, 0, 0}, 1, {2, 2, 2}, 0},
                  {{0, 0, 0}, 0, {1, 2, 2}, 3},
                  {{1, 0, 0}, 3, {2, 2, 2}, 0},
                  {{1, 0, 0}, 3, {2, 1.5f, 2}, 1},
                  {{1, 0.5f, 0}, 4, {2, 2, 2}, 1}};
    tree.primitives = {4, 3, 2, 1, 0};
    tree.levels = 3;
    return tree;
}

/// Small triangles on a grid of n × n.
AccelInput gridOf(int n, std::vector<glm::vec3>& vertices, std::vector<glm::uvec3>& triangles) {
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const auto first = static_cast<std::uint32_t>(vertices.size());
            const glm::vec3 corner(x, y, 0.1f * static_cast<float>(x * y % 7));
            vertices.insert(vertices.end(),
                            {corner, corner + glm::vec3(1, 0, 0), corner + glm::vec3(0, 1, 0)});
            triangles.push_back({first, first + 1, first + 2});
        }
    AccelInput input;
    input.vertices = vertices;
    input.triangles = triangles;
    return input;
}

TEST(TreeIndex, TreeComputedByHand) {
    const bvh::BinaryTree tree = handMadeTree();
    const probe::TreeIndex index = probe::indexTree(tree);
    EXPECT_EQ(index.parent, (std::vector<std::uint32_t>{bvh::kNoNode, 0, 0, 2, 2}));
    EXPECT_EQ(index.level, (std::vector<std::uint8_t>{0, 1, 1, 2, 2}));
    EXPECT_EQ(index.primitives, (std::vector<std::uint32_t>{5, 3, 2, 1, 1}));
    EXPECT_EQ(index.leaves, (std::vector<std::uint32_t>{1, 3, 4}));
    EXPECT_EQ(index.leafNumber(3), 1u);
    EXPECT_EQ(index.leafNumber(2), 3u);
    // Half areas: 12, 8, 8, 6.5, 6.5.
    EXPECT_DOUBLE_EQ(index.cost[2], 1.0 + 2.0 * 6.5 / 8.0);
    EXPECT_DOUBLE_EQ(index.cost[0], 1.0 + 8.0 / 12.0 * 3.0 + 8.0 / 12.0 * index.cost[2]);
    EXPECT_DOUBLE_EQ(index.cost[0], bvh::statisticsOf(tree).sahCost);
}

TEST(TreeIndex, LevelsAndLeaves) {
    const bvh::BinaryTree tree = handMadeTree();
    const probe::TreeIndex index = probe::indexTree(tree);
    using Nodes = std::vector<std::uint32_t>;
    EXPECT_EQ(probe::nodesAtLevel(tree, index, 0, false), Nodes{0});
    EXPECT_EQ(probe::nodesAtLevel(tree, index, 2, false), (Nodes{3, 4}));
    EXPECT_EQ(probe::nodesAtLevel(tree, index, 2, true), (Nodes{1, 3, 4}));
    EXPECT_EQ(probe::nodesAtLevel(tree, index, 9, false), Nodes{});
    const auto primitives = probe::primitivesOfLeaf(tree, 1);
    EXPECT_EQ(Nodes(primitives.begin(), primitives.end()), (Nodes{4, 3, 2}));
    EXPECT_TRUE(probe::primitivesOfLeaf(tree, 2).empty());
}

TEST(TreeIndex, OverlapIsTheSharedAreaOfTheChildren) {
    const bvh::BinaryTree tree = handMadeTree();
    EXPECT_DOUBLE_EQ(probe::childOverlap(tree, 2), (1.0 * 1.0 + 1.0 * 2.0 + 1.0 * 2.0) / 8.0);
    // Halves of a box share a face: a line through that face intersects both.
    EXPECT_DOUBLE_EQ(probe::childOverlap(tree, 0), 4.0 / 12.0);
    EXPECT_EQ(probe::childOverlap(tree, 1), 0.0);
}

TEST(TreeIndex, EmptyTree) {
    const probe::TreeIndex index = probe::indexTree({});
    EXPECT_TRUE(index.leaves.empty());
    EXPECT_TRUE(probe::nodesAtLevel({}, index, 0, true).empty());
    EXPECT_EQ(probe::compareAtLevel({}, index, {}, index, 0).boxes[0], 0u);
}

TEST(TreeIndex, AgreesWithTheStatisticsOfBuiltTrees) {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    const AccelInput input = gridOf(30, vertices, triangles);
    for (const BvhBuilder builder : {BvhBuilder::Median, BvhBuilder::Sah, BvhBuilder::SahBinned}) {
        BuildSettings settings;
        settings.builder = builder;
        const bvh::BinaryTree tree = bvh::buildBinaryTree(input, settings);
        const probe::TreeIndex index = probe::indexTree(tree);
        const bvh::TreeStatistics statistics = bvh::statisticsOf(tree);
        EXPECT_NEAR(index.cost[0], statistics.sahCost, 1e-9 * statistics.sahCost);
        EXPECT_EQ(index.leaves.size(), statistics.leaves);
        EXPECT_EQ(index.primitives[0], 900u);
        std::vector<std::uint32_t> all;
        for (const std::uint32_t node : probe::nodesAtLevel(tree, index, 4, true)) {
            // Together these boxes hold every primitive once.
            all.push_back(index.primitives[node]);
        }
        EXPECT_EQ(std::accumulate(all.begin(), all.end(), 0u), 900u);
    }
}

TEST(TreeIndex, SahReducesArea) {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    AccelInput input = gridOf(20, vertices, triangles);
    // A distant object, which the median split does not separate.
    for (const float x : {200.0f, 300.0f, 500.0f}) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
        triangles.push_back({first, first + 1, first + 2});
    }
    input.vertices = vertices;
    input.triangles = triangles;
    BuildSettings settings;
    const bvh::BinaryTree sah = bvh::buildBinaryTree(input, settings);
    settings.builder = BvhBuilder::Median;
    const bvh::BinaryTree median = bvh::buildBinaryTree(input, settings);
    const probe::LevelComparison compared =
        probe::compareAtLevel(sah, probe::indexTree(sah), median, probe::indexTree(median), 3);
    EXPECT_GT(compared.boxes[1], 1u);
    EXPECT_LT(compared.expectedHits[0], compared.expectedHits[1]);
    EXPECT_LT(compared.sahCost[0], compared.sahCost[1]);
}

}  // namespace
}  // namespace rayscope
