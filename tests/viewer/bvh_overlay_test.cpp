#include "viewer/overlay/bvh_overlay.h"

#include <gtest/gtest.h>

#include <thread>

#include "trace/compile.h"
#include "viewer/jobs/bvh_inspector.h"
#include "viewer/overlay/palette.h"

namespace rayscope::viewer {
namespace {

ViewFrame frameAt(glm::vec3 eye) {
    CameraDescription camera;
    camera.lookFrom = eye;
    camera.lookAt = eye + glm::vec3(0, 0, -1);
    return viewFrame(camera, 800, 600);
}

TEST(BoxSelection, LargeBoxesHaveAllEdgesAndSmallOnesOneStrokePerSquare) {
    const OverlayBoxes one{{{-1, -1, -1}, {1, 1, 1}}};
    EXPECT_EQ(selectBoxes(one, frameAt({0, 0, 5})).whole.size(), 1u);
    EXPECT_TRUE(selectBoxes(one, frameAt({0, 0, 5})).strokes.empty());
    EXPECT_EQ(selectBoxes(one, frameAt({0, 0, 5000})).strokes.size(), 1u);
    const OverlayBoxes many(1000, one[0]);
    EXPECT_EQ(selectBoxes(many, frameAt({0, 0, 5})).whole.size(), 1000u);
    EXPECT_EQ(selectBoxes(many, frameAt({0, 0, 5000})).strokes.size(), 1u);
    // With a limit the largest are whole.
    OverlayBoxes sizes;
    for (int i = 1; i <= 100; ++i) {
        const float half = 0.01f * static_cast<float>(i);
        sizes.push_back({glm::vec3(-half), glm::vec3(half)});
    }
    const BoxSelection ten = selectBoxes(sizes, frameAt({0, 0, 5}), 10);
    ASSERT_EQ(ten.whole.size(), 10u);
    EXPECT_EQ(ten.whole.front().lower, sizes[90].lower);
    EXPECT_EQ(ten.strokes.size(), 1u);
    EXPECT_GT(ten.large, 80u);
}

TEST(BoxSelection, DropsBoxesOutsideThePicture) {
    const OverlayBoxes one{{{-1, -1, -1}, {1, 1, 1}}};
    const auto boxesFrom = [&](glm::vec3 eye) {
        const BoxSelection choice = selectBoxes(one, frameAt(eye));
        return choice.whole.size() + choice.strokes.size();
    };
    EXPECT_EQ(boxesFrom({0, 0, -5}), 0u) << "behind the camera";
    EXPECT_EQ(boxesFrom({50, 0, 5}), 0u) << "beside the picture";
    EXPECT_EQ(selectBoxes(one, frameAt({0, 0, 0})).whole.size(), 1u) << "around the camera";
}

TEST(BoxSelection, IsBoundedByThePictureForAnyNumberOfBoxes) {
    OverlayBoxes boxes;
    for (int i = 0; i < 200000; ++i) {
        const glm::vec3 lower(static_cast<float>(i % 500) * 0.01f - 2.5f,
                              static_cast<float>(i / 500) * 0.01f - 2.0f, 0);
        boxes.push_back({lower, lower + 0.005f});
    }
    const std::size_t lines = selectBoxes(boxes, frameAt({0, 0, 5})).strokes.size();
    EXPECT_GT(lines, 5000u);
    EXPECT_LE(lines, 201u * 151u);
}

std::shared_ptr<const trace::World> worldOf(const std::string& name,
                                            BvhBuilder builder = BvhBuilder::SahBinned) {
    Diagnostics notes;
    const auto scene = std::make_shared<const SceneDescription>(loadScene("builtin:" + name, notes));
    Settings settings;
    settings.bvhBuilder = builder;
    return trace::compile({scene, settings, CameraDescription{}, 8, 8});
}

void waitUntilIdle(BvhInspector& inspector, const std::shared_ptr<const trace::World>& world) {
    for (int i = 0; i < 2000; ++i) {
        inspector.update(world);
        if (!inspector.busy()) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

TEST(BvhInspector, InspectsTheTraversedTreeAndTheReferenceTree) {
    const auto world = worldOf("monkey");
    BvhInspector inspector;
    waitUntilIdle(inspector, world);
    ASSERT_NE(inspector.inspected(), nullptr);
    EXPECT_EQ(&inspector.inspected()->tree(), world->motionGroups[0].accel->binaryTree());
    EXPECT_EQ(inspector.referenceTree(), nullptr) << "not requested";
    inspector.shown.showReference = true;
    waitUntilIdle(inspector, world);
    ASSERT_NE(inspector.referenceTree(), nullptr);
    EXPECT_EQ(inspector.referenceTree()->builder, BvhBuilder::Median);
    EXPECT_GT(inspector.referenceTree()->statistics.sahCost, inspector.inspected()->statistics.sahCost);

    // Boxes of both trees at a level: those of the reference tree come first, in red.
    inspector.shown.level = 3;
    const IndexedTree referenceTree = inspector.referenceTree()->indexed();
    const OverlayBoxes boxes = levelBoxes(inspector.inspected()->indexed(), &referenceTree, inspector.shown);
    EXPECT_EQ(boxes.front().color, palette::kReferenceBox);
    EXPECT_EQ(boxes.back().color, palette::kLevelBox);
    EXPECT_GT(boxes.size(), 8u);

    // Another world has another tree, and the old reference tree is not shown.
    const auto other = worldOf("monkey", BvhBuilder::Median);
    inspector.shown.showReference = false;
    waitUntilIdle(inspector, other);
    EXPECT_EQ(inspector.referenceTree(), nullptr);
    EXPECT_EQ(inspector.inspected()->accel, other->motionGroups[0].accel);
}

TEST(BvhInspector, SteppingThroughLeavesWrapsAround) {
    const auto world = worldOf("cornell");
    BvhInspector inspector;
    waitUntilIdle(inspector, world);
    const auto& leaves = inspector.inspected()->index.leaves;
    inspector.stepLeaf(1);
    EXPECT_TRUE(inspector.shown.leaf);
    EXPECT_EQ(inspector.shown.leafNumber, 0) << "the first step shows the current leaf";
    inspector.stepLeaf(-1);
    EXPECT_EQ(inspector.shown.leafNumber, static_cast<int>(leaves.size()) - 1);
    inspector.stepLeaf(1);
    EXPECT_EQ(inspector.shown.leafNumber, 0);
    for (std::uint32_t primitive = 0; primitive < world->primitiveCount(); ++primitive) {
        inspector.selectLeafOf(primitive);
        const auto held = probe::primitivesOfLeaf(inspector.inspected()->tree(), inspector.shown.node);
        EXPECT_NE(std::find(held.begin(), held.end(), primitive), held.end());
        EXPECT_EQ(leaves[static_cast<std::size_t>(inspector.shown.leafNumber)], inspector.shown.node);
    }
}

TEST(BvhInspector, HasNoTreeForAnEmptyScene) {
    const auto scene = std::make_shared<const SceneDescription>();
    BvhInspector inspector;
    waitUntilIdle(inspector, trace::compile({scene, Settings{}, CameraDescription{}, 8, 8}));
    EXPECT_EQ(inspector.inspected(), nullptr);
    inspector.stepLeaf(1);
    inspector.stepLevel(1);
    inspector.selectLeafOf(0);
}

TEST(BvhOverlay, DrawsTheBoxAndThePrimitivesOfALeaf) {
    const auto world = worldOf("spheres");
    BvhInspector inspector;
    waitUntilIdle(inspector, world);
    const BvhInspector::InspectedTree& inspected = *inspector.inspected();
    inspector.stepLeaf(1);
    const OverlayBoxes boxes = leafBoxes(inspected.indexed(), inspector.shown);
    ASSERT_EQ(boxes.size(), 1u);
    const auto primitives = probe::primitivesOfLeaf(inspected.tree(), inspected.index.leaves[0]);
    const OverlayLines lines = leafLines(inspected.indexed(), inspected.geometry->input, inspector.shown);
    EXPECT_EQ(lines.size(), primitives.size() * 3 * 32) << "three circles per sphere";
    for (const OverlayLine& line : lines)
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(line.from[axis], boxes[0].lower[axis] - 1e-4f);
            EXPECT_LE(line.from[axis], boxes[0].upper[axis] + 1e-4f);
        }
    inspector.shown.leafNumber = 1000;
    EXPECT_TRUE(leafBoxes(inspected.indexed(), inspector.shown).empty());
    EXPECT_TRUE(nodeBoxes(inspected.tree(), 1000000).empty());
    EXPECT_EQ(nodeBoxes(inspected.tree(), 0).size(), inspected.tree().nodes[0].isLeaf() ? 1u : 3u);
}

}  // namespace
}  // namespace rayscope::viewer
