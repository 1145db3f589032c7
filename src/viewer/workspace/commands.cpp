#include "viewer/workspace/commands.h"

#include <fmt/format.h>

namespace rayscope::viewer {

namespace {

constexpr int kCtrl = GLFW_MOD_CONTROL, kShift = GLFW_MOD_SHIFT;

// clang-format off
constexpr CommandInfo kCommands[] = {
    {Command::OpenScene, "File", "Open...", GLFW_KEY_O, kCtrl, "Open a scene file or a single OBJ mesh."},
    {Command::ReloadScene, "File", "Reload", GLFW_KEY_F5, 0, "Read the scene file again; keep camera and settings."},
    {Command::SaveImage, "File", "Save image", GLFW_KEY_S, kCtrl, "Write the picture to the current folder.", true},
    {Command::SaveScreenshot, "File", "Save screenshot", GLFW_KEY_S, kCtrl | kShift,
     "Write the whole window, including rays and panels."},
    {Command::RenderToFile, "File", "Render to file...", GLFW_KEY_F12, 0, "Render at any size and sample count."},
    {Command::Quit, "File", "Quit", GLFW_KEY_Q, kCtrl, "Close the window.", true},

    {Command::Undo, "Edit", "Undo", GLFW_KEY_Z, kCtrl, "Undo the last change of scene, settings or camera."},
    {Command::Redo, "Edit", "Redo", GLFW_KEY_Y, kCtrl, "Redo the last undone change."},
    {Command::CopyPixel, "Edit", "Copy pixel", GLFW_KEY_C, kCtrl, "Copy the values of the pixel under the cursor.", true},
    {Command::CopyCamera, "Edit", "Copy camera", GLFW_KEY_C, kCtrl | kShift,
     "Copy the camera as command-line options."},

    {Command::SwitchView, "View", "Ray-traced", GLFW_KEY_TAB, 0, "Switch between the rasterised and the ray-traced view."},
    {Command::PauseOrResume, "View", "Pause tracing", GLFW_KEY_SPACE, 0, "Pause or resume rendering."},
    {Command::ToggleHeatMap, "View", "Heat map", GLFW_KEY_M, 0, "Show the cost or the error of each pixel in false colour."},
    {Command::KeepPicture, "View", "Keep as A", GLFW_KEY_K, 0, "Keep the traced picture as A for comparison.", true},
    {Command::ComparePictures, "View", "Compare A with B", GLFW_KEY_V, 0, "Show the kept picture A beside the current picture B."},
    {Command::FlipPictures, "View", "Flip A and B", GLFW_KEY_X, 0, "Switch between A and B."},
    {Command::ToggleOverlay, "View", "Overlay", GLFW_KEY_O, 0, "Show or hide rays, lights and handles.", true},
    {Command::ToggleWireframe, "View", "Wireframe", GLFW_KEY_Z, 0, "Draw only edges in the rasterised view."},
    {Command::ToggleSidePanel, "View", "Side panel", GLFW_KEY_N, 0, "Show or hide the side panel."},
    {Command::ToggleFullScreen, "View", "Full screen", GLFW_KEY_F11, 0, "Switch full screen on or off."},
    {Command::IncreaseUiScale, "View", "Increase UI scale", GLFW_KEY_EQUAL, kCtrl, "Enlarge text and controls.", true},
    {Command::DecreaseUiScale, "View", "Decrease UI scale", GLFW_KEY_MINUS, kCtrl, "Shrink text and controls."},
    {Command::ResetUiScale, "View", "Reset UI scale", GLFW_KEY_0, kCtrl,
     "Use the scale of the monitor."},

    {Command::ResetCamera, "Camera", "Reset", GLFW_KEY_HOME, 0, "Return to the camera of the scene file."},
    {Command::FrameAll, "Camera", "Frame all", GLFW_KEY_F, 0, "Fit the whole scene into the picture."},
    {Command::FrontView, "Camera", "Front view", GLFW_KEY_KP_1, 0, "Look along -Z.", true},
    {Command::SideView, "Camera", "Side view", GLFW_KEY_KP_3, 0, "Look along -X."},
    {Command::TopView, "Camera", "Top view", GLFW_KEY_KP_7, 0, "Look along -Y."},
    {Command::FlyMode, "Camera", "Fly", GLFW_KEY_GRAVE_ACCENT, 0,
     "Drag to look around, W A S D Q E to move, wheel for the speed.", true},

    {Command::RecordRays, "Rays", "Record rays", GLFW_KEY_R, 0, "Record and draw the rays of the pixel under the cursor."},
    {Command::ClearRays, "Rays", "Clear rays", GLFW_KEY_C, 0, "Discard the recorded rays."},
    {Command::ToggleLiveRay, "Rays", "Live ray", GLFW_KEY_L, 0, "Keep recording the pixel under the cursor as it moves."},
    {Command::PinPixel, "Rays", "Pin pixel", GLFW_KEY_P, 0, "Keep the statistics of the recorded pixel for comparison."},
    {Command::HideRay, "Rays", "Hide", GLFW_KEY_H, 0, "Do not draw the selected ray.", true},
    {Command::IsolateRay, "Rays", "Isolate", GLFW_KEY_I, 0, "Draw only the selected ray, its ancestors and its shadow rays."},
    {Command::CopyRays, "Rays", "Copy as JSON", GLFW_KEY_J, 0, "Copy the ray tree of the selected sample as JSON."},
    {Command::ExportRays, "Rays", "Export", GLFW_KEY_J, kCtrl,
     "Write the rays as OBJ lines and as JSON to the current folder."},
    {Command::ToggleTraversal, "Rays", "BVH traversal", GLFW_KEY_T, 0,
     "Show the boxes that the selected ray visits, culls and misses.", true},
    {Command::StepForward, "Rays", "Step forward", GLFW_KEY_RIGHT, 0, "Advance the traversal by one step."},
    {Command::StepBack, "Rays", "Step back", GLFW_KEY_LEFT, 0, "Go back one step of the traversal."},
    {Command::JumpForward, "Rays", "Ten steps forward", GLFW_KEY_RIGHT, kShift, "Advance the traversal by ten steps."},
    {Command::JumpBack, "Rays", "Ten steps back", GLFW_KEY_LEFT, kShift, "Go back ten steps of the traversal."},
    {Command::Cancel, "Rays", "Cancel", GLFW_KEY_ESCAPE, 0, "Close the open window, else leave fly mode or the live ray, else clear the rays."},

    {Command::ToggleBvhLevels, "BVH", "Boxes of a level", GLFW_KEY_B, 0, "Show or hide the boxes of one level of the BVH."},
    {Command::NextLevel, "BVH", "Next level", GLFW_KEY_PAGE_DOWN, 0, "Show the boxes one level deeper."},
    {Command::PreviousLevel, "BVH", "Previous level", GLFW_KEY_PAGE_UP, 0, "Show the boxes one level higher."},
    {Command::NextLeaf, "BVH", "Next leaf", GLFW_KEY_PERIOD, 0, "Highlight the next leaf and its primitives.", true},
    {Command::PreviousLeaf, "BVH", "Previous leaf", GLFW_KEY_COMMA, 0, "Highlight the previous leaf and its primitives."},
    {Command::LeafUnderCursor, "BVH", "Leaf under the cursor", GLFW_KEY_G, 0,
     "Select the leaf of the primitive under the cursor."},

    {Command::ShowKeys, "Help", "Keys", GLFW_KEY_F1, 0, "List keys and mouse gestures."},
    {Command::ShowStatistics, "Help", "Statistics", GLFW_KEY_F2, 0, "Show frame times and ray counts."},
};

/// Alternative shortcuts.
struct Alias { int key, modifiers; Command command; };
constexpr Alias kAliases[] = {
    {GLFW_KEY_Z, kCtrl | kShift, Command::Redo},
    {GLFW_KEY_R, kShift, Command::ClearRays},
    {GLFW_KEY_KP_ADD, kCtrl, Command::IncreaseUiScale},
    {GLFW_KEY_EQUAL, kCtrl | kShift, Command::IncreaseUiScale},
    {GLFW_KEY_KP_SUBTRACT, kCtrl, Command::DecreaseUiScale},
    {GLFW_KEY_KP_0, kCtrl, Command::ResetUiScale},
    {GLFW_KEY_GRAVE_ACCENT, kShift, Command::FlyMode},
    {GLFW_KEY_SLASH, kShift, Command::ShowKeys},
};
// clang-format on

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
        case GLFW_KEY_PAGE_DOWN:
            return "Page down";
        case GLFW_KEY_PAGE_UP:
            return "Page up";
        default:
            return std::string(1, static_cast<char>(key));
    }
}

}  // namespace

std::span<const CommandInfo> commandTable() { return kCommands; }

const CommandInfo& infoOf(Command command) {
    for (const CommandInfo& info : kCommands)
        if (info.command == command) return info;
    return kCommands[0];
}

std::optional<Command> commandFor(int key, int modifiers) {
    const int relevant = modifiers & (kCtrl | kShift | GLFW_MOD_ALT);
    for (const CommandInfo& info : kCommands)
        if (info.key == key && info.modifiers == relevant) return info.command;
    for (const Alias& alias : kAliases)
        if (alias.key == key && alias.modifiers == relevant) return alias.command;
    return std::nullopt;
}

std::string shortcutText(const CommandInfo& info) {
    std::string text;
    if (info.modifiers & kShift) text += "Shift+";
    if (info.modifiers & kCtrl) text += "Ctrl+";
    return text + keyText(info.key);
}

}  // namespace rayscope::viewer
