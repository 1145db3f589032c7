// Panels of scene, settings, quality and robustness, driven by the labels of their controls.
#include <gtest/gtest.h>

#include <algorithm>

#include "panel_driver.h"
#include "settings/table.h"

namespace rayscope::viewer {
namespace {

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

TEST(Panels, DrawTextsOfAnyLength) {
    PanelDriver driver("cornell");
    SceneDescription scene = *driver.workspace.edit.scene;
    scene.title = std::string(200'000, 't');
    scene.materials[0].name = std::string(200'000, 'm');
    scene.materials[0].ks = Rgb(0.5f);
    driver.workspace.edit.scene = std::make_shared<const SceneDescription>(scene);
    driver.workspace.sceneNotes = {{Severity::Warning, std::string(200'000, 'w'), {"x.toml", 1, 1}}};
    for (const char* tab : kTabs) driver.click(tab);
    driver.click("Scene");
}

TEST(Panels, ViewButtonsSwitchTheView) {
    PanelDriver driver("cornell");
    driver.click("Ray-traced");
    EXPECT_TRUE(driver.workspace.view.traced);
    driver.click("Rasterised");
    EXPECT_FALSE(driver.workspace.view.traced);
}

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

TEST(ScenePanel, EditsTheCamera) {
    PanelDriver driver("cornell");
    CameraDescription& camera = driver.workspace.edit.camera;
    driver.type("Field of view", "70");
    EXPECT_FLOAT_EQ(camera.fov, 70.0f);
    driver.click("Copy as options");
    EXPECT_EQ(driver.takeCommands(), std::vector{Command::CopyCamera});
}

TEST(SettingsPanel, HasTheLensBesideDepthOfField) {
    PanelDriver driver("cornell");
    CameraDescription& camera = driver.workspace.edit.camera;
    EXPECT_TRUE(driver.shows("none (pinhole)")) << "in the tab Scene";
    driver.click("Settings");
    EXPECT_FALSE(driver.isEnabled("Depth of field"));
    driver.click("Camera/Lens");
    ASSERT_TRUE(camera.lens.has_value());
    driver.type("f-number", "2");
    driver.type("Focal length", "0.5");
    driver.type("Focus distance", "4");
    EXPECT_FLOAT_EQ(camera.lens->fNumber, 2.0f);
    EXPECT_FLOAT_EQ(camera.lens->focalLength, 0.5f);
    EXPECT_FLOAT_EQ(camera.lens->focusDistance, 4.0f);
    EXPECT_TRUE(driver.isEnabled("Depth of field"));
    driver.click("Focus on a pixel...");
    EXPECT_EQ(driver.takeCommands(), std::vector{Command::FocusOnPixel});
    driver.click("Camera/Lens");
    EXPECT_FALSE(camera.lens.has_value());
}

TEST(SettingsPanel, TooltipsOfDisabledRowsAreNotFaded) {
    PanelDriver driver("cornell");
    driver.click("Settings");
    ASSERT_FALSE(driver.isEnabled("Lens samples"));
    driver.hover("Lens samples");
    const auto reason = std::find_if(ui::items().begin(), ui::items().end(), [](const ui::Item& item) {
        return item.isText && item.path.find("Inactive: ") != std::string::npos;
    });
    ASSERT_NE(reason, ui::items().end());
    EXPECT_TRUE(reason->enabled) << "drawn with full opacity";
}

TEST(SettingsPanel, WideRangesHaveSliders) {
    PanelDriver driver("cornell", {{"bloom", "true"}});
    driver.click("Settings");
    Settings& settings = driver.workspace.edit.settings;
    driver.drag("Bloom threshold", 0.9f, 0.999f);
    EXPECT_GT(settings.bloomThreshold, 500.0f) << "the right end is the highest value";
    driver.drag("Bloom threshold", 0.999f, 0.001f);
    EXPECT_LT(settings.bloomThreshold, 0.01f);
    driver.drag("Bloom size", 0.5f, 0.5f);
    EXPECT_LT(settings.bloomSize, 100) << "the middle of the slider is far below that of the range";
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
    EXPECT_TRUE(driver.shows("no object moves"));
}

TEST(ScenePanel, TextsInOneLineDoNotOverlap) {
    PanelDriver driver("cornell");
    driver.workspace.setLights({});
    driver.click("Required features");
    int compared = 0;
    const std::vector<ui::Item>& items = ui::items();
    for (std::size_t i = 0; i + 1 < items.size(); ++i) {
        const ui::Item &left = items[i], &right = items[i + 1];
        if (!left.isText || !right.isText || std::abs(left.lower.y - right.lower.y) > 0.5f) continue;
        if (!left.path.starts_with("Scene/")) continue;
        EXPECT_LE(left.upper.x, right.lower.x) << left.path << " and " << right.path;
        ++compared;
    }
    EXPECT_GT(compared, 5);
    EXPECT_GT(driver.at("No lights: surfaces are black unless shading is off.").upper.y -
                  driver.at("No lights: surfaces are black unless shading is off.").lower.y,
              20.0f)
        << "wrapped instead of cut";
}

TEST(StatusBar, SaysNothingAboutSamplesOfTheRasterisedView) {
    PanelDriver driver("cornell", {{"spp", "1"}});
    driver.waitForWorld();
    driver.waitFor("rest", [&] { return !driver.workspace.render.busy(); });
    EXPECT_TRUE(driver.shows("Status bar/rasterised"));
    EXPECT_FALSE(driver.shows("samples"));
    EXPECT_FALSE(driver.shows("NaN"));
    driver.workspace.view.traced = true;
    driver.waitFor("picture", [&] { return driver.shows("Status bar/1/1 samples") && driver.shows("done"); });
    EXPECT_FALSE(driver.shows("NaN")) << "all samples are finite";
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

}  // namespace
}  // namespace rayscope::viewer
