#include "viewer/workspace/commands.h"

#include <gtest/gtest.h>

namespace rayscope::viewer {
namespace {

TEST(Commands, allShortcutsLeadToTheirOwnCommand) {
    for (const CommandInfo& info : commandTable()) {
        EXPECT_EQ(commandFor(info.shortcut.key, info.shortcut.modifiers), info.command) << info.label;
        for (const Shortcut& other : info.alternatives) {
            if (other == Shortcut{}) continue;
            EXPECT_EQ(commandFor(other.key, other.modifiers), info.command) << info.label;
        }
    }
}

TEST(Commands, allHaveTexts) {
    for (const CommandInfo& info : commandTable()) {
        EXPECT_NE(std::string(info.label), "");
        EXPECT_EQ(std::string(info.help).back(), '.') << info.label;
    }
}

TEST(Commands, doNotUseTheKeysOfFlyMode) {
    for (const int key : {GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D, GLFW_KEY_Q, GLFW_KEY_E})
        EXPECT_FALSE(commandFor(key, 0)) << key;
}

TEST(Commands, lockKeysDoNotMatter) {
    EXPECT_EQ(commandFor(GLFW_KEY_R, GLFW_MOD_NUM_LOCK | GLFW_MOD_CAPS_LOCK), Command::RecordRays);
}

TEST(Commands, shortcutTextsAreConventional) {
    EXPECT_EQ(shortcutText(infoOf(Command::SaveScreenshot)), "Shift+Ctrl+S");
    EXPECT_EQ(shortcutText(infoOf(Command::RenderToFile)), "F12");
    EXPECT_EQ(shortcutText(infoOf(Command::FrontView)), "Numpad 1");
}

}  // namespace
}  // namespace rayscope::viewer
