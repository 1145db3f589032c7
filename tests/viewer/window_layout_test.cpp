#include "viewer/model/window_layout.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace rayscope::viewer {
namespace {

WindowLayout changedLayout() {
    WindowLayout layout;
    layout.scale = 1.3f;
    layout.panelWidth = 512.5f;
    layout.panelOnLeft = true;
    layout.tab = "A/B";
    layout.sections = {{"Scene/Numerical robustness", true}, {"Rays/Traversal (T)", false}};
    return layout;
}

TEST(WindowLayout, isReadAsItWasWritten) {
    EXPECT_EQ(layoutFromText(toText({})), WindowLayout{});
    EXPECT_EQ(layoutFromText(toText(changedLayout())), changedLayout());
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "rayscope" / "window";
    EXPECT_EQ(readLayout(file), WindowLayout{}) << "no file";
    writeLayout(file, changedLayout());
    EXPECT_EQ(readLayout(file), changedLayout());
}

TEST(WindowLayout, damagedLinesLeaveTheDefaults) {
    for (const char* text :
         {"", "\n\n", "panel-width", "panel-width nan", "panel-width 1e9", "panel-width -3", "scale 0",
          "scale 99", "scale x", "unknown 7", "section", "section x", "tab"})
        EXPECT_EQ(layoutFromText(text), WindowLayout{}) << text;
    using namespace std::string_view_literals;
    EXPECT_EQ(layoutFromText("garbage\0\xff\npanel-width 300\nmore"sv).panelWidth, 300.0f);
}

TEST(WindowLayout, withoutAHomeIsNotStored) {
    writeLayout({}, changedLayout());
    EXPECT_EQ(readLayout({}), WindowLayout{});
}

}  // namespace
}  // namespace rayscope::viewer
