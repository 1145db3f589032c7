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

TEST(Menus, SetTheResolutionOfTheTracedView) {
    PanelDriver driver("cornell");
    driver.click("Menu/View");
    EXPECT_FALSE(driver.has("Smooth normals")) << "the settings switch both views";
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
    driver.workspace.errorMessage = "cannot read y.toml";
    driver.frame();
    driver.frame();
    driver.pressEnter();
    EXPECT_TRUE(driver.workspace.errorMessage.empty()) << "Enter closes it, too";
}

TEST(Menus, EscapeClosesMenusAndLists) {
    PanelDriver driver("cornell");
    driver.click("Menu/View");
    driver.click("Menu/View/Resolution of the traced view");
    ASSERT_TRUE(driver.has("Resolution of the traced view/50 %"));
    driver.pressKey(ImGuiKey_Escape);
    driver.frame();
    EXPECT_FALSE(driver.has("Menu/View/Wireframe"));
    driver.click("Contents/File");
    ASSERT_TRUE(driver.has("File/cube"));
    driver.pressKey(ImGuiKey_Escape);
    driver.frame();
    EXPECT_FALSE(driver.has("File/cube"));
}

TEST(Menus, CommandsForAPixelWaitForAClickOnOne) {
    PanelDriver driver("cornell");
    Workspace& workspace = driver.workspace;
    EXPECT_FALSE(workspace.awaitPixel(infoOf(Command::SwitchView))) << "needs no pixel";
    for (const Command command : {Command::RecordRays, Command::CopyPixel, Command::LeafUnderCursor,
                                  Command::CenterOnPixel, Command::FocusOnPixel}) {
        workspace.cursor.reset();
        EXPECT_TRUE(workspace.awaitPixel(infoOf(command)));
        EXPECT_EQ(workspace.view.picking, command);
        driver.frame();
        driver.frame();
        EXPECT_TRUE(driver.shows(std::string(infoOf(command).label) + ": click a pixel"));
        workspace.cursor = CursorInfo{};
        EXPECT_FALSE(workspace.awaitPixel(infoOf(command)));
        EXPECT_FALSE(workspace.view.picking) << "done";
    }
    workspace.cursor.reset();
    driver.click("Rays");
    driver.click("Record rays of a pixel...");
    EXPECT_EQ(driver.takeCommands(), std::vector{Command::RecordRays});
}

TEST(Menus, TheMenuOfAPixelActsOnThatPixel) {
    PanelDriver driver("cornell");
    Workspace& workspace = driver.workspace;
    CursorInfo info;
    info.pixel = {12, 34};
    info.object = "box";
    workspace.menuPixel = info;
    workspace.openPixelMenu = true;
    driver.frame();
    driver.frame();
    EXPECT_TRUE(driver.shows("Pixel 12, 34: box"));
    EXPECT_FALSE(driver.isEnabled("Pixel menu/Focus on pixel")) << "the camera has no lens";
    driver.click("Pixel menu/Record rays");
    EXPECT_EQ(driver.takeCommands(), std::vector{Command::RecordRays});
    ASSERT_TRUE(workspace.picked);
    EXPECT_EQ(workspace.picked->pixel, glm::ivec2(12, 34));
    EXPECT_FALSE(driver.has("Pixel menu/Record rays")) << "closed by the click";
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
    // The notice is shown for some seconds, the end of the load may take longer.
    driver.waitFor("notice", [&] { return driver.shows("Cancelled: builtin:ten-million was not loaded"); });
    driver.waitFor("end", [&] { return !driver.workspace.loader.busy(); });
    EXPECT_FALSE(driver.has("Loading/Cancel"));
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
    EXPECT_TRUE(driver.shows("Saved a.png in " + std::filesystem::current_path().string()));
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
    EXPECT_FALSE(driver.openDialog.busy()) << "a click selects";
    EXPECT_TRUE(driver.has("Open a scene/a.toml"));
    driver.doubleClick("Open a scene/more/");
    EXPECT_EQ(driver.workspace.loader.path(), "") << "a double click on a folder opens no file in it";
    driver.waitFor("the other list", [&] { return driver.has("Open a scene/d.obj"); });
    EXPECT_FALSE(driver.has("Open a scene/a.toml"));
    driver.click("Open a scene/d.obj");
    EXPECT_EQ(driver.workspace.loader.path(), "");
    driver.doubleClick("Open a scene/d.obj");
    EXPECT_EQ(driver.workspace.loader.path(), (folder / "more/d.obj").string());
}

TEST(Dialogs, RenderToAFile) {
    PanelDriver driver("cube", {{"spp", "1"}});
    driver.renderWindow.request(driver.workspace);
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
    driver.click("Render to file/Close");
    EXPECT_EQ(driver.workspace.job, nullptr);
    std::filesystem::remove(path);
}

TEST(Dialogs, RenderAsksBeforeItOverwrites) {
    const test::TemporaryFolder folder;
    const std::string path = (folder / "there.pfm").string();
    folder.write("there.pfm", "precious");
    PanelDriver driver("cube", {{"spp", "1"}});
    driver.renderWindow.request(driver.workspace);
    driver.frame();
    driver.frame();
    driver.replaceText("File (.png .exr .pfm .hdr .ppm .pgm)", path);
    const float button = driver.at("Render to file/Render").lower.y;
    driver.click("Render to file/Render");
    EXPECT_TRUE(driver.shows(path + " exists."));
    EXPECT_EQ(driver.workspace.job, nullptr);
    EXPECT_EQ(driver.at("Render to file/Render").lower.y, button) << "the question moves no button";
    driver.click("Render to file/Keep");
    EXPECT_EQ(driver.workspace.job, nullptr);
    EXPECT_EQ(std::filesystem::file_size(path), 8u);
    driver.click("Render to file/Render");
    driver.click("Render to file/Overwrite");
    driver.waitFor("file", [&] {
        driver.workspace.job->update();
        return driver.shows("Written: " + path);
    });
    EXPECT_GT(std::filesystem::file_size(path), 8u);
}

TEST(Dialogs, TheWindowStaysUsableWhileAFileIsRendered) {
    const test::TemporaryFolder folder;
    const std::string path = (folder / "long.pfm").string();
    PanelDriver driver("cube", {{"spp", "100000"}});
    driver.renderWindow.request(driver.workspace);
    driver.frame();
    driver.frame();
    driver.replaceText("File (.png .exr .pfm .hdr .ppm .pgm)", path);
    driver.click("Render to file/Render");
    ASSERT_TRUE(driver.workspace.job && driver.workspace.job->running());
    driver.click("Ray-traced");
    EXPECT_TRUE(driver.workspace.view.traced);
    driver.click("Render to file/Hide");
    EXPECT_FALSE(driver.has("Render to file/Cancel"));
    EXPECT_TRUE(driver.shows("rendering " + path)) << "in the status bar";
    driver.renderWindow.request(driver.workspace);
    driver.frame();
    driver.frame();
    driver.click("Render to file/Cancel");
    EXPECT_TRUE(driver.shows("Cancelled: no file written."));
    EXPECT_FALSE(std::filesystem::exists(path));
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
