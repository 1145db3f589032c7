// What controls of numbers take and what their tooltips say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "panel_driver.h"

namespace rayscope::viewer {
namespace {

/// 1e999 is infinite as a float. No control of a number takes it, as none takes a word.
TEST(Panels, RefuseNumbersThatAreNotFinite) {
    PanelDriver driver("cornell-area", {{"bloom", "true"}});
    const CameraDescription camera = driver.workspace.edit.camera;
    for (const char* label : {"Position##vector", "Look at##vector", "Up##vector", "Field of view"})
        for (const char* text : {"1e999", "-1e999", "1e39"}) {
            driver.type(label, text);
            EXPECT_EQ(driver.workspace.edit.camera, camera) << label << " " << text;
        }
    driver.click("Settings");
    driver.click("Camera/Lens");
    const EditState before = driver.workspace.edit;
    for (const char* label : {"f-number", "Focal length", "Focus distance", "Exposure", "Bloom threshold",
                              "Error target##error"}) {
        driver.type(label, "1e999");
        EXPECT_EQ(driver.workspace.edit, before) << label;
    }
    EXPECT_EQ(driver.workspace.stopCriteria, StopCriteria{});
}

/// The tooltip of a setting is the option for its value, and names the default.
TEST(SettingsPanel, TooltipsHaveTheValueAndTheDefault) {
    PanelDriver driver("cornell-area");
    driver.click("Settings");
    driver.workspace.edit.settings.segmentSamples = 64;
    driver.workspace.edit.settings.shading = false;
    driver.hover("Parallelogram samples");
    EXPECT_TRUE(driver.shows(
        fmt::format("--set parallelogram_samples={}", driver.workspace.edit.settings.parallelogramSamples)));
    driver.hover("Settings/Light/Shading");
    EXPECT_TRUE(driver.shows("--set shading=false"));
    EXPECT_TRUE(driver.shows("on or off, default true"));
}

}  // namespace
}  // namespace rayscope::viewer
