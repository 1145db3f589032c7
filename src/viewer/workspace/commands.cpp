#include "viewer/workspace/commands.h"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::viewer {

namespace {

std::string keyText(int key) {
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return fmt::format("F{}", key - GLFW_KEY_F1 + 1);
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return fmt::format("Numpad {}", key - GLFW_KEY_KP_0);
    switch (key) {
        case GLFW_KEY_TAB:
            return "Tab";
        case GLFW_KEY_SPACE:
            return "Space";
        case GLFW_KEY_HOME:
            return "Home";
        case GLFW_KEY_ESCAPE:
            return "Esc";
        case GLFW_KEY_RIGHT:
            return "Right";
        case GLFW_KEY_LEFT:
            return "Left";
        case GLFW_KEY_EQUAL:
            return "+";
        case GLFW_KEY_KP_DECIMAL:
            return "Numpad .";
        case GLFW_KEY_PAGE_DOWN:
            return "Page down";
        case GLFW_KEY_PAGE_UP:
            return "Page up";
        default:
            return std::string(1, static_cast<char>(key));
    }
}

}  // namespace

const CommandInfo& infoOf(Command command) { return commandTable()[static_cast<std::size_t>(command)]; }

std::optional<Command> commandFor(int key, int modifiers) {
    const Shortcut pressed{key, modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT)};
    for (const CommandInfo& info : commandTable())
        if (info.shortcut == pressed ||
            std::count(info.alternatives.begin(), info.alternatives.end(), pressed))
            return info.command;
    return std::nullopt;
}

std::string shortcutText(const CommandInfo& info) {
    std::string text;
    if (info.shortcut.modifiers & GLFW_MOD_SHIFT) text += "Shift+";
    if (info.shortcut.modifiers & GLFW_MOD_CONTROL) text += "Ctrl+";
    return text + keyText(info.shortcut.key);
}

}  // namespace rayscope::viewer
