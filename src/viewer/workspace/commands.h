#pragma once
// Everything that a menu item or a key can ask for, in one table: the menus, the shortcuts and the list of
// keys are made from it.
#include <GLFW/glfw3.h>

#include <optional>
#include <span>
#include <string>

namespace rayscope::viewer {

enum class Command {
    OpenScene,
    ReloadScene,
    SaveImage,
    SaveScreenshot,
    RenderToFile,
    Quit,
    Undo,
    Redo,
    CopyPixel,
    CopyCamera,
    SwitchView,
    RecordRays,
    ClearRays,
    ToggleOverlay,
    ToggleWireframe,
    ToggleSidePanel,
    ToggleFullScreen,
    IncreaseUiScale,
    DecreaseUiScale,
    ResetUiScale,
    PauseOrResume,
    ResetCamera,
    FrameAll,
    FlyMode,
    FrontView,
    SideView,
    TopView,
    ShowKeys,
    ShowStatistics,
    ToggleBvhLevels,
    NextLevel,
    PreviousLevel,
    NextLeaf,
    PreviousLeaf,
    LeafUnderCursor,
    ToggleTraversal,
    StepForward,
    StepBack,
    JumpForward,
    JumpBack,
    HideRay,
    ToggleLiveRay,
    ToggleHeatMap,
    KeepPicture,
    ComparePictures,
    FlipPictures,
    PinPixel,
    IsolateRay,
    CopyRays,
    ExportRays,
    Cancel,
};

struct CommandInfo {
    Command command;
    const char* menu;   ///< heading in the menu bar; "" for none
    const char* label;  ///< in the menu
    int key;            ///< GLFW_KEY_…
    int modifiers;      ///< GLFW_MOD_…
    const char* help;   ///< one sentence
    bool separatorBefore = false;
};

/// In the order of the menus.
std::span<const CommandInfo> commandTable();
const CommandInfo& infoOf(Command command);

/// The command on a key; several keys may lead to one command.
std::optional<Command> commandFor(int key, int modifiers);

/// "Shift+Ctrl+S".
std::string shortcutText(const CommandInfo& info);

}  // namespace rayscope::viewer
