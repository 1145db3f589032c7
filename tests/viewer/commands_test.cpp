#include "viewer/workspace/commands.h"

#include <gtest/gtest.h>

#include <set>

namespace rayscope::viewer {
namespace {

TEST(Commands, everyRowIsReachedByItsOwnKey) {
    for (const CommandInfo& info : commandTable())
        EXPECT_EQ(commandFor(info.key, info.modifiers), info.command) << info.label;
}

TEST(Commands, eachHasOneRow) {
    std::set<Command> seen;
    for (const CommandInfo& info : commandTable())
        EXPECT_TRUE(seen.insert(info.command).second) << info.label;
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(Command::Cancel) + 1);
}

TEST(Commands, leaveTheKeysOfFlyModeAlone) {
    for (const int key : {GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D, GLFW_KEY_Q, GLFW_KEY_E})
        EXPECT_FALSE(commandFor(key, 0)) << key;
}

TEST(Commands, lockKeysDoNotMatter) {
    EXPECT_EQ(commandFor(GLFW_KEY_R, GLFW_MOD_NUM_LOCK | GLFW_MOD_CAPS_LOCK), Command::RecordRays);
}

TEST(Commands, shortcutsReadAsPeopleWriteThem) {
    EXPECT_EQ(shortcutText(infoOf(Command::SaveScreenshot)), "Shift+Ctrl+S");
    EXPECT_EQ(shortcutText(infoOf(Command::RenderToFile)), "F12");
    EXPECT_EQ(shortcutText(infoOf(Command::FrontView)), "Numpad 1");
}

}  // namespace
}  // namespace rayscope::viewer
