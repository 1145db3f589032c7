// Panels of recorded rays, BVH, heat map and comparison, driven by the labels of their
// controls.
#include <gtest/gtest.h>

#include "panel_driver.h"
#include "viewer/overlay/debug_rays_overlay.h"

namespace rayscope::viewer {
namespace {

TEST(RaysPanel, EveryLegendEntrySwitchesItsKind) {
    PanelDriver driver("cornell");
    driver.click("Rays");
    DebugRayFilter& filter = driver.workspace.rays.filter;
    for (const RayLegendEntry& entry : debugRayLegend())
        expectToggle(driver, std::string("Legend (click to show or hide)/") + entry.label,
                     filter.*entry.shown);
}

TEST(RaysPanel, FiltersRays) {
    PanelDriver driver("monkey");
    driver.click("Rays");
    DebugRayFilter& filter = driver.workspace.rays.filter;
    driver.type("Max depth", "2");
    EXPECT_EQ(filter.maxDepth, 2);
    driver.type("Filters/Light", "1");
    EXPECT_EQ(filter.light, 1);
    driver.type("Min contribution", "0.5");
    EXPECT_FLOAT_EQ(filter.minContribution, 0.5f);
    driver.choose("Colour", "radiance");
    EXPECT_EQ(filter.colors, RayColors::IncomingRadiance);
}

TEST(RaysPanel, ShowsTheSamplesOfAPixel) {
    PanelDriver driver("cornell-area", {{"spp", "16"}});
    driver.recordPixel(32, 36);
    driver.click("Rays");
    DebugRays& rays = driver.workspace.rays;
    driver.type("Sample", "3");
    EXPECT_EQ(rays.recording()->tree().name.index, 3);
    driver.click("Draw all samples");
    EXPECT_TRUE(rays.filter.allSamples);
    driver.waitFor("samples", [&] { return driver.shows("16 of 16 drawn"); });
    driver.type("Memory limit", "2");
    EXPECT_EQ(rays.budget, std::size_t{2} << 20);
    for (const auto& [label, command] :
         {std::pair{"Copy JSON", Command::CopyRays}, std::pair{"Export OBJ", Command::ExportRays},
          std::pair{"Clear", Command::ClearRays}}) {
        driver.click(label);
        EXPECT_EQ(driver.takeCommands(), std::vector{command}) << label;
    }
    driver.workspace.edit.settings.spp = 17;
    driver.waitFor("the rays of 17 samples", [&] { return rays.recording()->samples() == 17; });
    driver.click("Freeze");
    driver.workspace.edit.settings.spp = 18;
    driver.frame();
    EXPECT_TRUE(driver.shows("Frozen: the scene or a setting changed"));
    driver.click("Freeze");
    driver.waitFor("the rays of 18 samples", [&] { return rays.recording()->samples() == 18; });
    EXPECT_FALSE(driver.shows("Frozen"));
}

TEST(RaysPanel, SelectsRaysInTheTable) {
    PanelDriver driver("cornell");
    driver.recordPixel(32, 24);
    driver.click("Rays");
    EXPECT_FALSE(driver.isEnabled("Hide (H)"));
    driver.click("camera 0");
    EXPECT_EQ(driver.workspace.rays.selection().node, 0);
    EXPECT_TRUE(driver.shows("Throughput"));
    EXPECT_FALSE(driver.isEnabled("Show all"));
    driver.click("Hide (H)");
    driver.click("Isolate (I)");
    EXPECT_EQ(driver.takeCommands(), (std::vector{Command::HideRay, Command::IsolateRay}));
    driver.workspace.hideSelectedRay();
    driver.frame();
    driver.click("Show all");
    EXPECT_EQ(driver.takeCommands(), std::vector{Command::ShowAllRays});
    driver.workspace.showAllRays();
    EXPECT_TRUE(driver.workspace.rays.filter.hidden.empty());
}

TEST(RaysPanel, NothingBelowMovesWhenRaysAreOutdated) {
    PanelDriver driver("cornell");
    driver.recordPixel(32, 24);
    driver.click("Rays");
    driver.click("Freeze");
    const float before = driver.at("Rays/Filters").lower.y;
    driver.workspace.edit.settings.maxDepth = 1;
    driver.frame();
    ASSERT_TRUE(driver.shows("the scene or a setting changed"));
    EXPECT_EQ(driver.at("Rays/Filters").lower.y, before);
}

struct BvhPanel : testing::Test {
    PanelDriver driver{"monkey"};
    BvhInspector& bvh = driver.workspace.bvh;

    void SetUp() override {
        driver.click("BVH");
        driver.waitFor("tree", [&] { return bvh.inspected() != nullptr; });
    }
};

TEST_F(BvhPanel, StepsThroughLevelsAndLeaves) {
    expectToggle(driver, "Boxes of a level (B)", bvh.shown.levels);
    expectToggle(driver, "Leaves above", bvh.shown.leavesAbove);
    expectToggle(driver, "Highlight one leaf", bvh.shown.leaf);
    driver.click("Boxes of a level (B)");
    driver.type("Boxes/Level", "5");
    EXPECT_EQ(bvh.shown.level, 5);
    driver.click("Level/>");
    EXPECT_EQ(bvh.shown.level, 6);
    driver.click("Level/<");
    EXPECT_EQ(bvh.shown.level, 5);
    driver.type("Boxes/Leaf", "7");
    EXPECT_EQ(bvh.shown.leafNumber, 7);
    const float below = driver.at("BVH/Build").lower.y;
    driver.click("Highlight one leaf");
    EXPECT_TRUE(driver.shows("primitives"));
    EXPECT_EQ(driver.at("BVH/Build").lower.y, below) << "nothing moves";
    driver.type("Max level", "3");
    EXPECT_EQ(driver.workspace.edit.settings.bvhMaxLevel, 3);
}

TEST_F(BvhPanel, ComparesWithAReferenceTree) {
    driver.click("Compare with another BVH");
    EXPECT_TRUE(bvh.shown.showReference);
    driver.waitFor("tree", [&] { return bvh.referenceTree() != nullptr; });
    driver.choose("Comparison with another BVH/Builder", "SAH");
    driver.frame();
    ASSERT_TRUE(bvh.compareWith.has_value());
    EXPECT_EQ(bvh.compareWith->builder, BvhBuilder::Sah);
    EXPECT_FALSE(driver.isEnabled("Bins")) << "the SAH sweep has no bins";
    driver.type("Comparison with another BVH/Leaf size", "8");
    EXPECT_EQ(bvh.compareWith->leafSize, 8);
    driver.waitFor("costs", [&] { return driver.shows("visits per ray"); });
}

TEST_F(BvhPanel, SelectsNodes) {
    EXPECT_TRUE(driver.shows("Click a node"));
    std::string root;
    for (const ui::Item& item : ui::items())
        if (item.path.find("/Nodes/node 0:") != std::string::npos) root = item.path;
    driver.click(root);
    EXPECT_EQ(bvh.shown.node, 0u);
    EXPECT_TRUE(driver.shows("Overlap"));
    driver.waitFor("curve", [&] { return driver.shows("Split of this tree"); });
}

TEST(HeatPanel, ChoosesQuantityColoursAndRange) {
    PanelDriver driver("cornell");
    driver.click("Map");
    HeatMap& heat = driver.workspace.heat;
    driver.click("Show heat map (M)");
    EXPECT_TRUE(heat.shown);
    EXPECT_TRUE(driver.workspace.view.traced) << "the map is shown in place of the traced picture";
    driver.choose("Quantity", "depth");
    EXPECT_EQ(infoOf(heat.aov).name, "depth");
    const std::string other(kColorMapNames[heat.map == ColorMap{0} ? 1 : 0]);
    driver.choose("Colour map", other);
    EXPECT_EQ(kColorMapNames[static_cast<int>(heat.map)], other);
    driver.type("Samples", "4");
    EXPECT_EQ(heat.samples, 4);
    driver.waitFor("map", [&] { return heat.values() != nullptr && !heat.busy(); });
    const float before = heat.to;
    driver.drag("Histogram", 0.95f, 0.6f);
    EXPECT_FALSE(heat.fitRange);
    EXPECT_NE(heat.to, before);
    driver.click("Fit range to values");
    EXPECT_TRUE(heat.fitRange);
    EXPECT_TRUE(driver.has("Colour bar")) << "on the picture";
    driver.click("Show heat map (M)");
    EXPECT_FALSE(driver.has("Colour bar"));
}

TEST(ComparisonPanel, ComparesTheKeptPicture) {
    PanelDriver driver("cornell", {{"spp", "2"}});
    driver.click("A/B");
    driver.click("Keep the traced picture as A (K)");
    EXPECT_EQ(driver.takeCommands(), std::vector{Command::KeepPicture});
    Comparison& comparison = driver.workspace.comparison;
    driver.workspace.keepPicture();
    EXPECT_EQ(comparison.a(), nullptr) << "no traced picture is shown";
    driver.workspace.view.traced = true;
    const auto isComplete = [&](int samples) {
        return driver.workspace.shown.leastSamples() == samples &&
               driver.workspace.shown.isFull(driver.workspace.edit, driver.workspace.imageSize());
    };
    driver.waitFor("the picture", [&] { return isComplete(2); });
    driver.workspace.keepPicture();
    ASSERT_NE(comparison.a(), nullptr);
    const Settings kept = driver.workspace.edit.settings;
    driver.workspace.edit.settings.spp = 3;
    driver.waitFor("one more sample", [&] { return isComplete(3); });
    EXPECT_TRUE(driver.shows("spp 2 -> 3"));
    EXPECT_TRUE(driver.shows("A: 2 samples per pixel, 64 x 48"));
    EXPECT_TRUE(driver.shows("B: 3 of 3 samples per pixel, 64 x 48"));
    comparison.view.shown = true;
    driver.frame();
    driver.type("Divider", "0.25");
    EXPECT_FLOAT_EQ(comparison.view.divider, 0.25f);
    driver.click("Flip");
    EXPECT_EQ(comparison.view.mode, CompareMode::Flip);
    driver.click("A/B/A");
    EXPECT_TRUE(comparison.view.flipped);
    driver.click("A/B/B");
    EXPECT_FALSE(comparison.view.flipped);
    driver.click("Difference");
    EXPECT_EQ(comparison.view.mode, CompareMode::Difference);
    driver.type("Scale", "10");
    EXPECT_FLOAT_EQ(comparison.view.brightness, 10.0f);
    driver.click("Restore settings");
    EXPECT_EQ(driver.workspace.edit.settings, kept);
    driver.click("Discard A");
    EXPECT_EQ(comparison.a(), nullptr);
}

}  // namespace
}  // namespace rayscope::viewer
