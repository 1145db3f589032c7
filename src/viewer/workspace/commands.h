#pragma once
// The commands of menus and keys. Their table, with a function for each, is app/command_table.cpp; menus,
// shortcuts and the list of keys are made from it.
#include <GLFW/glfw3.h>

#include <array>
#include <optional>
#include <span>
#include <string>

namespace rayscope::viewer {

class Application;
struct Workspace;

/// In the order of the menus.
enum class Command {
    OpenScene,
    ReloadScene,
    SaveScene,
    SaveImage,
    SaveScreenshot,
    RenderToFile,
    Quit,
    Undo,
    Redo,
    CopyPixel,
    CopyCamera,
    SwitchView,
    PauseOrResume,
    ToggleHeatMap,
    KeepPicture,
    ComparePictures,
    FlipPictures,
    ToggleOverlay,
    ToggleWireframe,
    ToggleSidePanel,
    MoveSidePanel,
    ToggleFullScreen,
    IncreaseUiScale,
    DecreaseUiScale,
    ResetUiScale,
    ResetLayout,
    ResetCamera,
    FrameAll,
    FrontView,
    SideView,
    TopView,
    BackView,
    LeftView,
    BottomView,
    CenterOnPixel,
    FocusOnPixel,
    FlyMode,
    RecordRays,
    ClearRays,
    ToggleLiveRay,
    PinPixel,
    HideRay,
    IsolateRay,
    ShowAllRays,
    CopyRays,
    ExportRays,
    ToggleTraversal,
    StepForward,
    StepBack,
    JumpForward,
    JumpBack,
    Cancel,
    ToggleBvhLevels,
    NextLevel,
    PreviousLevel,
    NextLeaf,
    PreviousLeaf,
    LeafUnderCursor,
    ShowKeys,
    ShowStatistics,
    Count  ///< the number of commands
};

struct Shortcut {
    int key = 0;        ///< GLFW_KEY_…; 0: none
    int modifiers = 0;  ///< GLFW_MOD_…
    bool operator==(const Shortcut&) const = default;
};

struct CommandInfo {
    Command command;
    const char* menu;   ///< heading in the menu bar
    const char* label;  ///< in the menu
    const char* help;   ///< one sentence
    Shortcut shortcut;  ///< shown beside the label
    std::array<Shortcut, 2> alternatives{};
    bool separatorBefore = false;
    /// Called after the frame's input, when the pixel under the cursor is known.
    void (*execute)(Application&);
    bool (*enabled)(const Workspace&) = nullptr;  ///< null: always
    bool (*checked)(const Workspace&) = nullptr;  ///< null: the entry has no check mark
    bool needsPixel = false;  ///< acts on the pixel under the cursor; elsewhere it waits for a click on one
};

/// One row per command, in the order of the enumeration. Defined by the application, whose functions it
/// calls.
std::span<const CommandInfo> commandTable();
const CommandInfo& infoOf(Command command);

/// The command of a key; lock keys do not matter.
std::optional<Command> commandFor(int key, int modifiers);

/// "Shift+Ctrl+S".
std::string shortcutText(const CommandInfo& info);

}  // namespace rayscope::viewer
