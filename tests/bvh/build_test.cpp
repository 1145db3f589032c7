// Guarantees of builders about their trees.
#include <gtest/gtest.h>
#include <rayscope/diagnostics.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstring>
#include <thread>

#include "bvh/builders/build.h"
#include "bvh/meshes.h"

namespace rayscope::test {
namespace {

constexpr BvhBuilder kBuilders[] = {BvhBuilder::Median, BvhBuilder::Sah, BvhBuilder::SahBinned,
                                    BvhBuilder::SahReinsertion};

BuildSettings settingsOf(BvhBuilder builder, int leafSize = 4, int maxLevel = 64, int bins = 32) {
    BuildSettings settings;
    settings.builder = builder;
    settings.leafSize = leafSize;
    settings.maxLevel = maxLevel;
    settings.bins = bins;
    return settings;
}

bool contains(const bvh::BinaryNode& outer, const glm::vec3& point) {
    return glm::all(glm::lessThanEqual(outer.lower, point)) &&
           glm::all(glm::lessThanEqual(point, outer.upper));
}

/// Checks the whole tree: every primitive once, boxes tight around leaves and around children, limits
/// respected.
void checkTree(const bvh::BinaryTree& tree, const AccelInput& input, const BuildSettings& settings) {
    const std::size_t primitives = input.triangles.size() + input.spheres.size() - tree.droppedPrimitives;
    ASSERT_EQ(tree.primitives.size(), primitives);
    if (primitives == 0) {
        EXPECT_TRUE(tree.nodes.empty());
        EXPECT_EQ(tree.levels, 0);
        return;
    }
    std::vector<char> occurrences(input.triangles.size() + input.spheres.size());
    std::size_t slots = 0, nodes = 0;
    int deepest = 0;
    struct StackEntry {
        std::uint32_t node;
        int level;
    };
    std::vector<StackEntry> stack{{0, 0}};
    while (!stack.empty()) {
        const auto [number, level] = stack.back();
        stack.pop_back();
        ++nodes;
        deepest = std::max(deepest, level);
        ASSERT_LT(number, tree.nodes.size());
        const bvh::BinaryNode& node = tree.nodes[number];
        if (!node.isLeaf()) {
            const bvh::BinaryNode &left = tree.nodes[node.first], &right = tree.nodes[node.first + 1];
            ASSERT_EQ(node.lower, glm::min(left.lower, right.lower));
            ASSERT_EQ(node.upper, glm::max(left.upper, right.upper));
            stack.push_back({node.first, level + 1});
            stack.push_back({node.first + 1, level + 1});
            continue;
        }
        if (level < settings.maxLevel) {
            ASSERT_LE(node.count, static_cast<unsigned>(settings.leafSize));
        }
        for (std::uint32_t slot = node.first; slot < node.first + node.count; ++slot, ++slots) {
            const std::uint32_t primitive = tree.primitives[slot];
            ASSERT_EQ(occurrences[primitive]++, 0);
            if (primitive >= input.triangles.size()) continue;
            for (int k = 0; k < 3; ++k)
                ASSERT_TRUE(contains(node, input.vertices[input.triangles[primitive][k]]));
        }
    }
    EXPECT_EQ(slots, primitives);
    EXPECT_EQ(nodes, tree.nodes.size());
    EXPECT_EQ(tree.levels, deepest + 1);
    EXPECT_LE(deepest, settings.maxLevel);
}

TEST(Build, EveryTreeIsValid) {
    for (const TestGeometry& scene : edgeCaseScenes())
        for (const BvhBuilder builder : kBuilders)
            for (const int leafSize : {1, 4, 16})
                for (const int maxLevel : {0, 1, 5, 64})
                    for (const int bins : {2, 16, 4096}) {
                        if (builder != BvhBuilder::SahBinned && bins != 16) continue;
                        SCOPED_TRACE(scene.name);
                        const BuildSettings settings = settingsOf(builder, leafSize, maxLevel, bins);
                        checkTree(bvh::buildBinaryTree(scene.input(), settings), scene.input(), settings);
                        if (HasFatalFailure()) return;
                    }
}

TEST(Build, LargeTreesAreValid) {
    const TestGeometry scene = soup(60000, 0.05, 5);
    for (const BvhBuilder builder : kBuilders) {
        const BuildSettings settings = settingsOf(builder);
        checkTree(bvh::buildBinaryTree(scene.input(), settings), scene.input(), settings);
    }
}

TEST(Build, MedianSplitHasTheLevelsOfABalancedTree) {
    const auto levels = [](int triangles) {
        return bvh::buildBinaryTree(soup(triangles, 0.1, 1).input(), settingsOf(BvhBuilder::Median, 1))
            .levels;
    };
    EXPECT_EQ(levels(32), 6);
    EXPECT_EQ(levels(967), 11);
    EXPECT_EQ(levels(15704), 15);
}

TEST(Build, EqualCentroidsAreSplitInHalf) {
    TestGeometry scene;
    for (int i = 0; i < 100000; ++i) scene.spheres.push_back({{0.5f, 0.25f, 1.0f}, 1.0f});
    for (const BvhBuilder builder : kBuilders)
        EXPECT_EQ(bvh::buildBinaryTree(scene.input(), settingsOf(builder, 1)).levels, 18)
            << static_cast<int>(builder);
}

TEST(Build, SahSeparatesDistantClusters) {
    TestGeometry scene;  // one triangle far from seven: the median would cut through the seven
    for (int i = 0; i < 7; ++i) {
        const float x = 0.01f * static_cast<float>(i);
        scene.addTriangle({x, 0, 0}, {x, 1, 0}, {x, 0, 1});
    }
    scene.addTriangle({100, 0, 0}, {100, 1, 0}, {100, 0, 1});
    for (const auto& [builder, bins] :
         {std::pair{BvhBuilder::Sah, 32}, {BvhBuilder::SahBinned, 4}, {BvhBuilder::SahReinsertion, 4}}) {
        const bvh::BinaryTree tree = bvh::buildBinaryTree(scene.input(), settingsOf(builder, 1, 64, bins));
        const bvh::BinaryNode& right = tree.nodes[tree.nodes[0].first + 1];
        ASSERT_TRUE(right.isLeaf());
        EXPECT_EQ(tree.primitives[right.first], 7u);
    }
}

TEST(Build, SameTreeForAnyNumberOfThreads) {
    TestGeometry scene = soup(150000, 0.03, 9);
    for (int i = 0; i < 20000; ++i)
        scene.triangles.push_back(scene.triangles[static_cast<std::size_t>(i / 100)]);
    for (const BvhBuilder builder : kBuilders) {
        std::vector<bvh::BinaryTree> trees;
        for (const int threads : {1, 2, 4}) {
            tbb::task_arena arena(threads);
            arena.execute([&] { trees.push_back(bvh::buildBinaryTree(scene.input(), settingsOf(builder))); });
        }
        for (std::size_t i = 1; i < trees.size(); ++i) {
            ASSERT_EQ(trees[i].nodes.size(), trees[0].nodes.size());
            EXPECT_EQ(std::memcmp(trees[i].nodes.data(), trees[0].nodes.data(),
                                  trees[0].nodes.size() * sizeof(bvh::BinaryNode)),
                      0);
            EXPECT_EQ(trees[i].primitives, trees[0].primitives);
        }
    }
}

TEST(Build, DropsAndCountsNonFinitePrimitives) {
    const std::vector<TestGeometry> scenes = edgeCaseScenes();
    const auto scene = std::find_if(scenes.begin(), scenes.end(),
                                    [](const TestGeometry& g) { return g.name == "not finite"; });
    ASSERT_NE(scene, scenes.end());
    EXPECT_EQ(bvh::buildBinaryTree(scene->input(), {}).droppedPrimitives, 7u);
}

TEST(Build, EmptyInput) {
    const bvh::BinaryTree tree = bvh::buildBinaryTree({}, {});
    EXPECT_TRUE(tree.nodes.empty());
    TestGeometry scene;
    scene.vertices.assign(3, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    scene.triangles = {{0, 1, 2}};
    EXPECT_EQ(bvh::buildBinaryTree(scene.input(), {}).droppedPrimitives, 1u);
    EXPECT_TRUE(bvh::buildBinaryTree(scene.input(), {}).nodes.empty());
}

TEST(Build, ReportsTheFirstInvalidVertexIndex) {
    TestGeometry scene = soup(50000, 0.1, 2);
    scene.triangles[41234].y = 150000;
    scene.triangles[49999].x = 4000000000u;
    try {
        Accel::build(scene.input());
        FAIL() << "no exception";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "triangle 41234 has vertex index 150000, but there are 150000 vertices");
    }
}

TEST(Build, RefusesTooManyPrimitives) {
    const glm::uvec3 triangle{};
    AccelInput input;
    input.triangles = std::span(&triangle, (std::size_t{1} << 32) - 1);  // never read
    EXPECT_THROW(Accel::build(input), std::length_error);
}

TEST(Build, RefusesSettingsOutOfRange) {
    for (const BuildSettings& settings :
         {settingsOf(BvhBuilder::Sah, 0), settingsOf(BvhBuilder::Sah, 4, -1),
          settingsOf(BvhBuilder::Sah, 4, 65), settingsOf(BvhBuilder::SahBinned, 4, 64, 1),
          settingsOf(BvhBuilder::SahBinned, 4, 64, 4097)})
        EXPECT_THROW(Accel::build({}, settings), std::invalid_argument);
}

TEST(Build, StopsOnRequest) {
    const TestGeometry scene = soup(300000, 0.02, 13);
    for (const BvhBuilder builder : kBuilders) {
        std::stop_source before;
        before.request_stop();
        BuildSettings settings = settingsOf(builder);
        settings.stop = before.get_token();
        EXPECT_THROW(Accel::build(scene.input(), settings), Stopped);

        std::stop_source during;
        settings.stop = during.get_token();
        const std::jthread stopper([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            during.request_stop();
        });
        try {
            Accel::build(scene.input(), settings);  // a very fast machine may be done by now
        } catch (const Stopped&) {
        }
    }
}

}  // namespace
}  // namespace rayscope::test
