// Removals of recorded rays as steps of undo; the marks of recorded pixels.
#include <gtest/gtest.h>

#include "panel_driver.h"
#include "viewer/app/command_actions.h"
#include "viewer/model/projection.h"

namespace rayscope::viewer {
namespace {

TEST(PixelMarks, AreAtTheSurfacesOfRecordedAndPinnedPixels) {
    PanelDriver driver("cornell");
    Workspace& workspace = driver.workspace;
    EXPECT_TRUE(pixelMarks(workspace).empty());
    driver.recordPixel(32, 24);
    workspace.rays.pin();
    driver.recordPixel(32, 20);
    std::vector<PixelMark> marks = pixelMarks(workspace);
    ASSERT_EQ(marks.size(), 2u);
    EXPECT_EQ(marks[0].label, "1");
    EXPECT_LT(glm::distance(marks[0].pixel, glm::vec2(32.5f, 24.5f)), 0.75f);
    EXPECT_TRUE(marks[1].recorded);
    EXPECT_LT(glm::distance(marks[1].pixel, glm::vec2(32.5f, 20.5f)), 0.75f);
    // The camera looks from elsewhere: the marks stay on the surfaces.
    workspace.edit.camera.lookFrom.x += 1.0f;
    const std::vector<PixelMark> moved = pixelMarks(workspace);
    EXPECT_GT(moved.empty() ? 100.0f : glm::distance(moved[0].pixel, marks[0].pixel), 0.75f);
    workspace.rays.clear();
    workspace.rays.pins.clear();
    EXPECT_TRUE(pixelMarks(workspace).empty());
}

struct UndoneRays : testing::Test {
    PanelDriver driver{"cornell"};
    Workspace& workspace = driver.workspace;
    DebugRays& rays = workspace.rays;

    void SetUp() override { driver.recordPixel(32, 24); }
    const void* recorded() const { return rays.recording() ? rays.recording()->world.get() : nullptr; }
};

TEST_F(UndoneRays, ComeBack) {
    const void* const before = recorded();
    EXPECT_FALSE(workspace.canUndo());
    workspace.clearRays();
    EXPECT_EQ(recorded(), nullptr);
    ASSERT_TRUE(workspace.canUndo());
    workspace.undo();
    EXPECT_EQ(recorded(), before);
    EXPECT_FALSE(workspace.canUndo());
    workspace.redo();
    EXPECT_EQ(recorded(), nullptr);
    EXPECT_FALSE(workspace.canRedo());
}

TEST_F(UndoneRays, AreStepsBetweenEdits) {
    const EditState first = workspace.edit;
    workspace.edit.settings.maxDepth = 3;
    workspace.record();
    workspace.rays.select({0, -1});
    workspace.hideSelectedRay();
    EXPECT_EQ(rays.filter.hidden.size(), 1u);
    workspace.edit.settings.maxDepth = 4;
    workspace.record();
    workspace.undo();
    EXPECT_EQ(workspace.edit.settings.maxDepth, 3);
    EXPECT_EQ(rays.filter.hidden.size(), 1u);
    workspace.undo();
    EXPECT_EQ(workspace.edit.settings.maxDepth, 3);
    EXPECT_TRUE(rays.filter.hidden.empty());
    workspace.undo();
    EXPECT_EQ(workspace.edit, first);
    for (int step = 0; step < 3; ++step) workspace.redo();
    EXPECT_EQ(workspace.edit.settings.maxDepth, 4);
    EXPECT_EQ(rays.filter.hidden.size(), 1u);
    workspace.undo();
    workspace.undo();
    workspace.undo();
    workspace.edit.settings.maxDepth = 9;
    workspace.record();
    EXPECT_FALSE(workspace.canRedo()) << "an edit discards what was undone";
}

TEST_F(UndoneRays, HideNoRayOfAnotherSample) {
    rays.select({0, -1});
    workspace.hideSelectedRay();
    rays.select({1, -1});
    workspace.hideSelectedRay();
    driver.recordPixel(20, 40);
    EXPECT_TRUE(rays.filter.hidden.empty());
    workspace.undo();
    EXPECT_TRUE(rays.filter.hidden.empty()) << "indices of the other pixel mean other rays here";
}

TEST(RaysPanel, ShowsTheTraversalOfBothTrees) {
    PanelDriver driver("monkey");
    driver.recordPixel(32, 24);
    driver.click("Rays");
    TraversalOverlayOptions& traversal = driver.workspace.rays.traversal;
    EXPECT_FALSE(driver.has("Binary"));
    driver.click("Traversal (T)/Draw");
    EXPECT_TRUE(traversal.shown);
    expectToggle(driver, "Culled", traversal.culled);
    expectToggle(driver, "Missed", traversal.missed);
    driver.click("Step by step");
    driver.frame();
    driver.type("Step", "4");
    EXPECT_EQ(traversal.step, 4);
    EXPECT_TRUE(driver.shows("Interval"));
    driver.click("Wide");
    EXPECT_EQ(traversal.layout, BvhLayout::Wide);
    EXPECT_EQ(traversal.step, 0) << "another tree has other steps";
    driver.click("Binary");
    EXPECT_EQ(traversal.layout, BvhLayout::Binary);
    expectToggle(driver, "Glossy square", driver.workspace.rays.surface.glossySquare);
    expectToggle(driver, "Lens and focus", driver.workspace.rays.surface.lens);
}

TEST(RaysPanel, PinsPixels) {
    PanelDriver driver("cornell");
    driver.click("Rays");
    EXPECT_TRUE(driver.shows("Press P"));
    driver.recordPixel(32, 24);
    driver.workspace.rays.pin();
    driver.frame();
    driver.click("Pinned pixels/32, 24");
    EXPECT_TRUE(driver.workspace.rays.pins.empty());
}

// Commands that act on the surface under the cursor.

TEST(PixelCommands, CenterAndFocusOnTheSurface) {
    PanelDriver driver("spheres-dof");
    Workspace& workspace = driver.workspace;
    CameraDescription& camera = workspace.edit.camera;
    ASSERT_TRUE(camera.lens);
    const CameraDescription before = camera;
    workspace.cursor = CursorInfo{};
    focusOnPixel(workspace);
    centerOnPixel(workspace);
    EXPECT_EQ(camera, before) << "nothing is hit";
    const ViewFrame frame = viewFrame(camera, 64, 48);
    workspace.cursor->position = frame.eye + 5.0 * frame.forward + 2.0 * frame.right;
    focusOnPixel(workspace);
    EXPECT_NEAR(camera.lens->focusDistance, 5.0f, 1e-5f) << "the distance of the plane, not of the point";
    centerOnPixel(workspace);
    EXPECT_LT(glm::distance(glm::dvec3(camera.lookAt), *workspace.cursor->position), 1e-5);
    EXPECT_EQ(camera.lookFrom, before.lookFrom);
}

}  // namespace
}  // namespace rayscope::viewer
