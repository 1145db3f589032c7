// Every panel of the window, driven by the labels of its controls.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "panel_driver.h"
#include "settings/table.h"
#include "viewer/overlay/debug_rays_overlay.h"

namespace rayscope::viewer {
namespace {

/// Clicks a toggle twice and expects it to switch and to switch back.
void expectToggle(PanelDriver& driver, const std::string& label, const bool& value) {
    const bool before = value;
    driver.click(label);
    EXPECT_NE(value, before) << label;
    driver.click(label);
    EXPECT_EQ(value, before) << label;
}

const char* const kTabs[] = {"Scene", "Settings", "Rays", "BVH", "Map", "A/B"};

TEST(Panels, DrawForEveryBuiltinScene) {
    for (const BuiltinScene& scene : builtinScenes()) {
        // The dragon is fetched, the large ones take seconds.
        if (scene.name == "dragon" || scene.name.ends_with("million")) continue;
        PanelDriver driver(scene.name, {{"spp", "2"}});
        driver.workspace.view.traced = true;
        driver.recordPixel(32, 24);
        for (const char* tab : kTabs) {
            driver.click(tab);
            EXPECT_TRUE(std::any_of(
                ui::items().begin(), ui::items().end(),
                [&](const ui::Item& item) { return item.path.starts_with(std::string(tab) + "/"); }))
                << scene.name << " " << tab;
        }
    }
}

TEST(Panels, ViewButtonsSwitchTheView) {
    PanelDriver driver("cornell");
    driver.click("Ray-traced");
    EXPECT_TRUE(driver.workspace.view.traced);
    driver.click("Rasterised");
    EXPECT_FALSE(driver.workspace.view.traced);
}

// --- Settings
// -----------------------------------------------------------------------------------------------

void changeByControl(PanelDriver& driver, const std::string& path, const settings::Toggle& row) {
    const bool before = driver.workspace.edit.settings.*row.member;
    driver.click(path);
    EXPECT_EQ(driver.workspace.edit.settings.*row.member, !before) << path;
}

template <class T>
void changeByControl(PanelDriver& driver, const std::string& path, const settings::Range<T>& row) {
    driver.type(path, "3");
    EXPECT_EQ(driver.workspace.edit.settings.*row.member, T(3)) << path;
}

template <class E, std::size_t N>
void changeByControl(PanelDriver& driver, const std::string& path, const settings::Choice<E, N>& row) {
    const auto before = static_cast<std::size_t>(driver.workspace.edit.settings.*row.member);
    const std::size_t other = (before + 1) % N;
    driver.choose(path, std::string(row.names[other]));
    EXPECT_EQ(static_cast<std::size_t>(driver.workspace.edit.settings.*row.member), other) << path;
}

TEST(SettingsPanel, EveryControlChangesItsSettingAndResets) {
    PanelDriver driver("cornell");
    driver.click("Settings");
    driver.click("Settings/Acceleration");
    int tried = 0;
    settings::forEachSetting([&](const auto& row) {
        Settings& edited = driver.workspace.edit.settings;
        edited = Settings{};
        driver.frame();
        const std::string path =
            "Settings/" + std::string(row.text.group) + "/" + std::string(row.text.label) + "##value";
        ASSERT_TRUE(driver.has(path)) << path;
        if (!driver.isEnabled(path)) {
            const Settings before = edited;
            driver.click(path);
            EXPECT_EQ(edited, before) << "disabled: " << path;
            return;
        }
        ++tried;
        changeByControl(driver, path, row);
        EXPECT_NE(edited, Settings{}) << path;
        Settings onlyThis;
        onlyThis.*row.member = edited.*row.member;
        EXPECT_EQ(edited, onlyThis) << "no other setting: " << path;
        driver.doubleClickLabel("Settings/" + std::string(row.text.group) + "/" +
                                std::string(row.text.label));
        EXPECT_EQ(edited, Settings{}) << "a double click on the label resets: " << path;
    });
    EXPECT_GT(tried, 15);
}

TEST(SettingsPanel, ResetsAllSettings) {
    PanelDriver driver("cornell", {{"spp", "7"}, {"bloom", "true"}});
    driver.click("Settings");
    driver.click("Reset all settings");
    EXPECT_EQ(driver.workspace.edit.settings, Settings{});
}

TEST(QualityPanel, SetsPresetAndStopCriteria) {
    PanelDriver driver("cornell");
    driver.click("Settings");
    driver.type("Quality/Preset", "0");
    EXPECT_EQ(driver.workspace.edit.settings.maxDepth, 2) << "the first preset is 'preview'";
    StopCriteria& stop = driver.workspace.stopCriteria;
    driver.click("Error target##byError");
    EXPECT_TRUE(stop.byError);
    driver.type("Error target##error", "0.02");
    EXPECT_FLOAT_EQ(stop.error, 0.02f);
    driver.type("Confidence level", "90");
    EXPECT_FLOAT_EQ(stop.confidence, 0.9f);
    driver.click("Time limit##byTime");
    EXPECT_TRUE(stop.byTime);
    driver.type("Time limit##seconds", "5");
    EXPECT_FLOAT_EQ(stop.seconds, 5.0f);
}

TEST(TradePanel, StartsAndStops) {
    PanelDriver driver("cube", {{"spp", "1"}});
    driver.click("Settings");
    driver.click("Quality-speed study");
    driver.type("Time budget", "2");
    EXPECT_FLOAT_EQ(driver.workspace.trade.budget, 2.0f);
    driver.click("Measure quality and speed");
    driver.waitFor("job", [&] { return driver.has("Stop and keep the results so far"); });
    driver.click("Stop and keep the results so far");
    driver.waitFor("end", [&] { return !driver.workspace.trade.busy(); });
    EXPECT_TRUE(driver.has("Measure quality and speed"));
}

// --- Scene
// --------------------------------------------------------------------------------------------------

TEST(ScenePanel, EditsTheCamera) {
    PanelDriver driver("cornell");
    CameraDescription& camera = driver.workspace.edit.camera;
    driver.type("Field of view", "70");
    EXPECT_FLOAT_EQ(camera.fov, 70.0f);
    driver.click("Lens");
    ASSERT_TRUE(camera.lens.has_value());
    driver.type("f-number", "2");
    driver.type("Focal length", "0.5");
    driver.type("Focus distance", "4");
    EXPECT_FLOAT_EQ(camera.lens->fNumber, 2.0f);
    EXPECT_FLOAT_EQ(camera.lens->focalLength, 0.5f);
    EXPECT_FLOAT_EQ(camera.lens->focusDistance, 4.0f);
    driver.click("Lens");
    EXPECT_FALSE(camera.lens.has_value());
    driver.click("Copy as options");
    EXPECT_EQ(driver.takeCommands(), std::vector{Command::CopyCamera});
}

TEST(ScenePanel, SetsTheCameraFromOptions) {
    PanelDriver driver("cornell");
    driver.click("Set from options...");
    driver.replaceText("Camera options/Options", "--fov 33");
    driver.click("Camera options/Set");
    EXPECT_FLOAT_EQ(driver.workspace.edit.camera.fov, 33.0f);
}

TEST(ScenePanel, AddsEditsAndRemovesLights) {
    PanelDriver driver("cornell");
    const auto lights = [&]() -> const std::vector<Light>& { return driver.workspace.edit.scene->lights; };
    ASSERT_EQ(lights().size(), 1u);
    for (const char* label : {"+ Point", "+ Segment", "+ Parallelogram"}) driver.click(label);
    ASSERT_EQ(lights().size(), 4u);
    EXPECT_EQ(lights()[3].shape.index(), 2u);
    EXPECT_EQ(driver.workspace.view.selectedLight, 3);
    driver.choose("Handle", "corner");
    EXPECT_EQ(driver.workspace.view.selectedHandle, 1);
    driver.click("Inverse-square");
    EXPECT_NE(lights()[3].falloff, lights()[2].falloff);
    driver.click("Remove");
    EXPECT_EQ(lights().size(), 3u);
    driver.click("Light 1: Point");
    EXPECT_EQ(driver.workspace.view.selectedLight, 1);
    driver.click("Light 1: Point");
    EXPECT_EQ(driver.workspace.view.selectedLight, -1);
}

TEST(ScenePanel, OpensBuiltinScenesAndTheDialog) {
    PanelDriver driver("cornell");
    driver.choose("Contents/File", "cube");
    EXPECT_EQ(driver.workspace.loader.path(), "builtin:cube");
    driver.click("Contents/Open...");
    EXPECT_EQ(driver.takeCommands(), std::vector{Command::OpenScene});
    driver.openDialog.request();
    driver.waitFor("dialog", [&] { return driver.has("Open a scene/Cancel"); });
    driver.click("Open a scene/Cancel");
    EXPECT_FALSE(driver.has("Open a scene/Cancel"));
}

TEST(ScenePanel, ListsRequiredFeatures) {
    PanelDriver driver("cornell");
    EXPECT_TRUE(driver.shows("32 triangles, 1 mesh"));
    driver.click("Required features");
    EXPECT_TRUE(driver.shows("nothing moves"));
}

TEST(LabPanel, TestsTheSceneAndDrawsFailures) {
    PanelDriver driver("cube");
    driver.click("Numerical robustness");
    LabJob& lab = driver.workspace.lab;
    driver.click("Test numerical robustness");
    driver.waitFor("result", [&] { return lab.result() != nullptr; });
    EXPECT_TRUE(driver.shows("test points fail"));
    expectToggle(driver, "Draw failed rays", lab.overlay);
    expectToggle(driver, "Coarse steps", lab.quick);
    const LabMethod other = kLabMethods[lab.shownMethod == kLabMethods[0] ? 1 : 0];
    driver.choose("Method", infoOf(other).label);
    EXPECT_EQ(lab.shownMethod, other);
}

// --- Rays
// ---------------------------------------------------------------------------------------------------

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
    driver.frame();
    EXPECT_TRUE(driver.shows("Outdated"));
}

TEST(RaysPanel, SelectsRaysInTheTable) {
    PanelDriver driver("cornell");
    driver.recordPixel(32, 24);
    driver.click("Rays");
    EXPECT_FALSE(driver.isEnabled("Hide (H)"));
    driver.click("camera 0");
    EXPECT_EQ(driver.workspace.rays.selection().node, 0);
    EXPECT_TRUE(driver.shows("Throughput"));
    driver.click("Hide (H)");
    driver.click("Isolate (I)");
    EXPECT_EQ(driver.takeCommands(), (std::vector{Command::HideRay, Command::IsolateRay}));
    driver.workspace.rays.hideSelected();
    driver.frame();
    driver.click("Show 1 hidden rays");
    EXPECT_TRUE(driver.workspace.rays.filter.hidden.empty());
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

// --- BVH
// ----------------------------------------------------------------------------------------------------

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
    driver.click("Highlight one leaf");
    EXPECT_TRUE(driver.shows("primitives"));
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

// --- Map and comparison
// -------------------------------------------------------------------------------------

TEST(HeatPanel, ChoosesQuantityColoursAndRange) {
    PanelDriver driver("cornell");
    driver.click("Map");
    HeatMap& heat = driver.workspace.heat;
    driver.click("Show heat map (M)");
    EXPECT_TRUE(heat.shown);
    EXPECT_TRUE(driver.workspace.view.traced) << "the map is shown in place of the traced picture";
    driver.choose("Quantity", "depth");
    EXPECT_EQ(probe::infoOf(heat.aov).name, "depth");
    const std::string other(post::kColorMapNames[heat.map == post::ColorMap{0} ? 1 : 0]);
    driver.choose("Colour map", other);
    EXPECT_EQ(post::kColorMapNames[static_cast<int>(heat.map)], other);
    driver.type("Samples", "4");
    EXPECT_EQ(heat.samples, 4);
    driver.waitFor("map", [&] { return heat.values() != nullptr && !heat.busy(); });
    const float before = heat.to;
    driver.drag("Histogram", 0.95f, 0.6f);
    EXPECT_FALSE(heat.fitRange);
    EXPECT_NE(heat.to, before);
    driver.click("Fit range to values");
    EXPECT_TRUE(heat.fitRange);
}

TEST(ComparisonPanel, ComparesTheKeptPicture) {
    PanelDriver driver("cornell", {{"spp", "2"}});
    driver.click("A/B");
    driver.click("Keep the traced picture as A (K)");
    EXPECT_EQ(driver.takeCommands(), std::vector{Command::KeepPicture});
    Comparison& comparison = driver.workspace.comparison;
    comparison.keep(driver.workspace.edit, RgbImage(64, 48), 2);
    const Settings kept = driver.workspace.edit.settings;
    driver.workspace.edit.settings.spp = 3;
    driver.frame();
    EXPECT_TRUE(driver.shows("spp 2 -> 3"));
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

// --- Menus and dialogs
// --------------------------------------------------------------------------------------

TEST(Menus, EveryEntryAsksForItsCommand) {
    PanelDriver driver("cornell");
    driver.recordPixel(32, 24);
    int asked = 0;
    for (const CommandInfo& info : commandTable()) {
        const std::string menu = std::string("Menu/") + info.menu, entry = menu + "/" + info.label;
        driver.click(menu);
        ASSERT_TRUE(driver.has(entry)) << entry;
        const bool enabled = driver.isEnabled(entry);
        driver.click(entry);
        if (enabled) {
            EXPECT_EQ(driver.takeCommands(), std::vector{info.command}) << entry;
            ++asked;
        } else {
            EXPECT_TRUE(driver.takeCommands().empty()) << entry;
            driver.clickPicture();
        }
    }
    EXPECT_GT(asked, 40);
}

TEST(Menus, SwitchTheRasterisedView) {
    PanelDriver driver("cornell");
    driver.click("Menu/View");
    driver.click("Smooth normals");
    EXPECT_FALSE(driver.workspace.view.raster.smoothNormals);
    driver.click("Menu/View");
    driver.click("Resolution of the traced view");
    driver.click("Resolution of the traced view/50 %");
    EXPECT_FLOAT_EQ(driver.workspace.view.resolution, 0.5f);
}

TEST(Dialogs, ShowAnErrorUntilItIsClosed) {
    PanelDriver driver("cornell");
    driver.workspace.errorMessage = "cannot read x.toml";
    driver.frame();
    driver.frame();
    EXPECT_TRUE(driver.shows("cannot read x.toml"));
    driver.click("Error/Close");
    EXPECT_TRUE(driver.workspace.errorMessage.empty());
    EXPECT_FALSE(driver.has("Error/Close"));
}

TEST(Dialogs, OpenAFileByItsPath) {
    PanelDriver driver("cornell");
    driver.openDialog.request();
    driver.frame();
    driver.frame();
    ImGui::GetIO().AddInputCharactersUTF8("builtin:cube");
    driver.frame();
    driver.pressEnter();
    EXPECT_EQ(driver.workspace.loader.path(), "builtin:cube");
}

TEST(Dialogs, RenderToAFile) {
    PanelDriver driver("cube", {{"spp", "1"}});
    driver.renderDialog.request();
    driver.frame();
    driver.frame();
    const std::string path = testing::TempDir() + "panels_test_render.pfm";
    driver.replaceText("File (.png .exr .pfm .hdr)", path);
    driver.click("Render to file/Render");
    driver.waitFor("file", [&] {
        driver.workspace.job->update();
        return driver.shows("Written: " + path);
    });
    EXPECT_TRUE(std::filesystem::exists(path));
    std::filesystem::remove(path);
    driver.click("Render to file/Close");
    EXPECT_EQ(driver.workspace.job, nullptr);
}

TEST(Dialogs, ListKeysAndStatistics) {
    PanelDriver driver("cornell");
    driver.workspace.view.showKeys = driver.workspace.view.showStatistics = true;
    driver.frame();
    driver.frame();
    for (const CommandInfo& info : commandTable()) EXPECT_TRUE(driver.shows(info.help)) << info.help;
    driver.workspace.frameTimes.add(0.01);
    driver.click("Statistics/Reset");
    EXPECT_EQ(driver.workspace.frameTimes.count(), 0u);
}

}  // namespace
}  // namespace rayscope::viewer
