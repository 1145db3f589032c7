// The menu bar and the dialogs, driven by the labels of their controls.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "panel_driver.h"
#include "support/temporary_folder.h"

namespace rayscope::viewer {
namespace {

TEST(Menus, EveryEntryIssuesItsCommand) {
    PanelDriver driver("cornell");
    driver.recordPixel(32, 24);
    int issued = 0;
    for (const CommandInfo& info : commandTable()) {
        const std::string menu = std::string("Menu/") + info.menu, entry = menu + "/" + info.label;
        driver.click(menu);
        ASSERT_TRUE(driver.has(entry)) << entry;
        const bool enabled = driver.isEnabled(entry);
        driver.click(entry);
        if (enabled) {
            EXPECT_EQ(driver.takeCommands(), std::vector{info.command}) << entry;
            ++issued;
        } else {
            EXPECT_TRUE(driver.takeCommands().empty()) << entry;
            driver.clickPicture();
        }
    }
    EXPECT_GT(issued, 40);
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

TEST(Dialogs, CancelALoad) {
    PanelDriver driver("cornell");
    const EditState before = driver.workspace.edit;
    driver.workspace.open("builtin:ten-million");
    driver.waitFor("progress", [&] { return driver.has("Loading/Cancel"); });
    EXPECT_TRUE(driver.shows("Loading/builtin:ten-million"));
    driver.waitFor("step", [&] { return driver.shows("Loading/mesh 1 of 1: generating a terrain"); });
    EXPECT_TRUE(driver.shows("Status bar/loading builtin:ten-million: mesh 1 of 1: generating a terrain, "));
    driver.click("Loading/Cancel");
    driver.waitFor("end", [&] { return !driver.workspace.loader.busy(); });
    EXPECT_FALSE(driver.has("Loading/Cancel"));
    EXPECT_TRUE(driver.shows("Cancelled: builtin:ten-million was not loaded"));
    EXPECT_EQ(driver.workspace.edit, before);
    EXPECT_TRUE(driver.workspace.errorMessage.empty());
}

TEST(Dialogs, ShortLoadsOpenNoWindow) {
    PanelDriver driver("cornell");
    driver.workspace.open("builtin:cube");
    while (driver.workspace.loader.busy()) {
        driver.frame();
        EXPECT_FALSE(driver.has("Loading/Cancel"));
    }
    EXPECT_EQ(driver.workspace.edit.scene->path, "builtin:cube");
}

TEST(Dialogs, SavesAreReported) {
    PanelDriver driver("cornell");
    driver.workspace.saves.add({"a.png"}, [] { std::this_thread::sleep_for(std::chrono::milliseconds(50)); });
    driver.frame();
    EXPECT_TRUE(driver.shows("saving a.png"));
    driver.waitFor("end", [&] { return !driver.workspace.saves.busy(); });
    EXPECT_TRUE(driver.shows("Saved a.png"));
    driver.workspace.saves.add({"b.png"}, [] { throw InputError("disk full", {"b.png"}); });
    driver.waitFor("error", [&] { return driver.shows("b.png: error: disk full"); });
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

TEST(Dialogs, ListFoldersAndSceneFiles) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a.toml", "b.OBJ", "c.txt", ".hidden.toml"}) folder.write(name, "");
    std::filesystem::create_directory(folder / "more");
    folder.write("more/d.obj", "");
    PanelDriver driver("cornell");
    driver.openDialog.request();
    driver.frame();
    driver.frame();
    ImGui::GetIO().AddInputCharactersUTF8(folder.path().c_str());
    driver.frame();
    driver.pressEnter();
    driver.waitFor("list", [&] { return driver.has("Open a scene/a.toml"); });
    EXPECT_TRUE(driver.has("Open a scene/b.OBJ"));
    EXPECT_TRUE(driver.has("Open a scene/more/"));
    EXPECT_FALSE(driver.has("Open a scene/c.txt"));
    EXPECT_FALSE(driver.has("Open a scene/.hidden.toml"));
    driver.click("Open a scene/more/");
    driver.waitFor("the other list", [&] { return driver.has("Open a scene/d.obj"); });
    EXPECT_FALSE(driver.has("Open a scene/a.toml"));
}

TEST(Dialogs, RenderToAFile) {
    PanelDriver driver("cube", {{"spp", "1"}});
    driver.renderDialog.request();
    driver.frame();
    driver.frame();
    const std::string path = testing::TempDir() + "panels_test_render.pfm";
    driver.replaceText("File (.png .exr .pfm .hdr .ppm .pgm)", path);
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
