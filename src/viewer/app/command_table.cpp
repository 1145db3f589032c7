// All commands: names, keys and functions.
#include <type_traits>

#include "viewer/app/application.h"
#include "viewer/model/camera_controller.h"

namespace rayscope::viewer {

namespace {

constexpr int kCtrl = GLFW_MOD_CONTROL, kShift = GLFW_MOD_SHIFT;
constexpr float kScaleStep = 0.25f;

void toggle(bool& value) { value = !value; }

void toggleHeatMap(Workspace& workspace) {
    toggle(workspace.heat.shown);
    workspace.view.traced |= workspace.heat.shown;
}

void toggleComparison(Workspace& workspace) {
    toggle(workspace.comparison.view.shown);
    workspace.view.traced |= workspace.comparison.visible();
}

void flipPictures(Workspace& workspace) {
    workspace.comparison.view.mode = CompareMode::Flip;
    toggle(workspace.comparison.view.flipped);
}

void resetCamera(Workspace& workspace) { workspace.edit.camera = requestFor(workspace.edit.scene).camera; }

void selectLeafUnderCursor(Workspace& workspace) {
    const auto world = workspace.render.session().world();
    if (!world || !workspace.cursor || workspace.cursor->primitive == kNoPrimitive) return;
    workspace.bvh.selectLeafOf(world->locatePrimitive(workspace.cursor->primitive).inGroup);
}

/// The first that applies: cancel loading, close the list of keys, leave fly mode, end the live ray, clear
/// the rays.
void cancel(Workspace& workspace) {
    if (workspace.loader.loading()) {
        workspace.cancelLoading();
        return;
    }
    ViewState& view = workspace.view;
    for (bool* mode : {&view.showKeys, &view.flying, &view.liveRay})
        if (std::exchange(*mode, false)) return;
    workspace.rays.clear();
}

}  // namespace

/// A class, because its rows use private members of Application.
struct CommandTable {
    template <auto action>
    static void perform(Application& app) {
        if constexpr (std::is_member_function_pointer_v<decltype(action)>)
            (app.*action)();
        else
            action(app.workspace_);
    }

    // clang-format off
    static constexpr CommandInfo kRows[] = {
        {.command = Command::OpenScene, .menu = "File", .label = "Open...",
         .help = "Open a scene file or a single mesh.",
         .shortcut = {GLFW_KEY_O, kCtrl}, .execute = [](Application& app) { app.openDialog_.request(); }},
        {.command = Command::ReloadScene, .menu = "File", .label = "Reload",
         .help = "Read the scene file again; keep camera and settings.",
         .shortcut = {GLFW_KEY_F5},
         .execute = [](Application& app) {
             app.workspace_.loader.start(app.workspace_.edit.scene->path, true); },
         .enabled = [](const Workspace& w) { return !w.edit.scene->path.empty(); }},
        {.command = Command::SaveImage, .menu = "File", .label = "Save image",
         .help = "Write the picture to the current folder.",
         .shortcut = {GLFW_KEY_S, kCtrl}, .separatorBefore = true, .execute = perform<&Application::saveImage>},
        {.command = Command::SaveScreenshot, .menu = "File", .label = "Save screenshot",
         .help = "Write the whole window, including rays and panels.",
         .shortcut = {GLFW_KEY_S, kCtrl | kShift},
         .execute = [](Application& app) { app.screenshotRequested_ = true; }},
        {.command = Command::RenderToFile, .menu = "File", .label = "Render to file...",
         .help = "Render at any size and sample count.",
         .shortcut = {GLFW_KEY_F12}, .execute = [](Application& app) { app.renderDialog_.request(); }},
        {.command = Command::Quit, .menu = "File", .label = "Quit", .help = "Close the window.",
         .shortcut = {GLFW_KEY_Q, kCtrl}, .separatorBefore = true,
         .execute = [](Application& app) { app.window_.close(); }},

        {.command = Command::Undo, .menu = "Edit", .label = "Undo",
         .help = "Undo the last change of scene, settings or camera.",
         .shortcut = {GLFW_KEY_Z, kCtrl},
         .execute = [](Application& app) { app.workspace_.undo(); },
         .enabled = [](const Workspace& w) { return w.history.canUndo(); }},
        {.command = Command::Redo, .menu = "Edit", .label = "Redo", .help = "Redo the last undone change.",
         .shortcut = {GLFW_KEY_Y, kCtrl}, .alternatives = {{{GLFW_KEY_Z, kCtrl | kShift}}},
         .execute = [](Application& app) { app.workspace_.redo(); },
         .enabled = [](const Workspace& w) { return w.history.canRedo(); }},
        {.command = Command::CopyPixel, .menu = "Edit", .label = "Copy pixel",
         .help = "Copy the values of the pixel under the cursor.",
         .shortcut = {GLFW_KEY_C, kCtrl}, .separatorBefore = true, .execute = perform<&Application::copyPixel>},
        {.command = Command::CopyCamera, .menu = "Edit", .label = "Copy camera",
         .help = "Copy the camera as command-line options.",
         .shortcut = {GLFW_KEY_C, kCtrl | kShift}, .execute = perform<&Application::copyCamera>},

        {.command = Command::SwitchView, .menu = "View", .label = "Ray-traced",
         .help = "Switch between the rasterised and the ray-traced view.",
         .shortcut = {GLFW_KEY_TAB},
         .execute = [](Application& app) { toggle(app.workspace_.view.traced); },
         .checked = [](const Workspace& w) { return w.view.traced; }},
        {.command = Command::PauseOrResume, .menu = "View", .label = "Pause tracing",
         .help = "Pause or resume rendering.",
         .shortcut = {GLFW_KEY_SPACE},
         .execute = [](Application& app) { app.workspace_.render.togglePause(); },
         .checked = [](const Workspace& w) { return w.render.paused(); }},
        {.command = Command::ToggleHeatMap, .menu = "View", .label = "Heat map",
         .help = "Show the cost or the error of each pixel in false colour.",
         .shortcut = {GLFW_KEY_M},
         .execute = perform<toggleHeatMap>, .checked = [](const Workspace& w) { return w.heat.shown; }},
        {.command = Command::KeepPicture, .menu = "View", .label = "Keep as A",
         .help = "Keep the traced picture as A for comparison.",
         .shortcut = {GLFW_KEY_K}, .separatorBefore = true, .execute = perform<&Application::keepPicture>},
        {.command = Command::ComparePictures, .menu = "View", .label = "Compare A with B",
         .help = "Show the kept picture A beside the current picture B.",
         .shortcut = {GLFW_KEY_V},
         .execute = perform<toggleComparison>,
         .enabled = [](const Workspace& w) { return w.comparison.a() != nullptr; },
         .checked = [](const Workspace& w) { return w.comparison.visible(); }},
        {.command = Command::FlipPictures, .menu = "View", .label = "Flip A and B",
         .help = "Switch between A and B.",
         .shortcut = {GLFW_KEY_X},
         .execute = perform<flipPictures>,
         .enabled = [](const Workspace& w) { return w.comparison.a() != nullptr; }},
        {.command = Command::ToggleOverlay, .menu = "View", .label = "Overlay",
         .help = "Show or hide rays, lights and handles.",
         .shortcut = {GLFW_KEY_O}, .separatorBefore = true,
         .execute = [](Application& app) { toggle(app.workspace_.view.overlay); },
         .checked = [](const Workspace& w) { return w.view.overlay; }},
        {.command = Command::ToggleWireframe, .menu = "View", .label = "Wireframe",
         .help = "Draw only edges in the rasterised view.",
         .shortcut = {GLFW_KEY_Z},
         .execute = [](Application& app) { toggle(app.workspace_.view.raster.wireframe); },
         .checked = [](const Workspace& w) { return w.view.raster.wireframe; }},
        {.command = Command::ToggleSidePanel, .menu = "View", .label = "Side panel",
         .help = "Show or hide the side panel.",
         .shortcut = {GLFW_KEY_N},
         .execute = [](Application& app) { toggle(app.workspace_.view.sidePanel); },
         .checked = [](const Workspace& w) { return w.view.sidePanel; }},
        {.command = Command::ToggleFullScreen, .menu = "View", .label = "Full screen",
         .help = "Switch full screen on or off.",
         .shortcut = {GLFW_KEY_F11}, .execute = [](Application& app) { app.window_.toggleFullScreen(); }},
        {.command = Command::IncreaseUiScale, .menu = "View", .label = "Increase UI scale",
         .help = "Enlarge text and controls.",
         .shortcut = {GLFW_KEY_EQUAL, kCtrl},
         .alternatives = {{{GLFW_KEY_KP_ADD, kCtrl}, {GLFW_KEY_EQUAL, kCtrl | kShift}}}, .separatorBefore = true,
         .execute = [](Application& app) { app.setScale(app.workspace_.view.scale + kScaleStep); }},
        {.command = Command::DecreaseUiScale, .menu = "View", .label = "Decrease UI scale",
         .help = "Shrink text and controls.",
         .shortcut = {GLFW_KEY_MINUS, kCtrl}, .alternatives = {{{GLFW_KEY_KP_SUBTRACT, kCtrl}}},
         .execute = [](Application& app) { app.setScale(app.workspace_.view.scale - kScaleStep); }},
        {.command = Command::ResetUiScale, .menu = "View", .label = "Reset UI scale",
         .help = "Use the scale of the monitor.",
         .shortcut = {GLFW_KEY_0, kCtrl}, .alternatives = {{{GLFW_KEY_KP_0, kCtrl}}},
         .execute = [](Application& app) { app.setScale(app.window_.contentScale()); }},

        {.command = Command::ResetCamera, .menu = "Camera", .label = "Reset",
         .help = "Return to the camera of the scene file.",
         .shortcut = {GLFW_KEY_HOME}, .execute = perform<resetCamera>},
        {.command = Command::FrameAll, .menu = "Camera", .label = "Frame all",
         .help = "Fit the whole scene into the picture.",
         .shortcut = {GLFW_KEY_F}, .execute = perform<&Application::frameScene>},
        {.command = Command::FrontView, .menu = "Camera", .label = "Front view", .help = "Look along -Z.",
         .shortcut = {GLFW_KEY_KP_1}, .separatorBefore = true,
         .execute = [](Application& app) { viewAlong(app.workspace_.edit.camera, {0.0, 0.0, 1.0}); }},
        {.command = Command::SideView, .menu = "Camera", .label = "Side view", .help = "Look along -X.",
         .shortcut = {GLFW_KEY_KP_3},
         .execute = [](Application& app) { viewAlong(app.workspace_.edit.camera, {1.0, 0.0, 0.0}); }},
        {.command = Command::TopView, .menu = "Camera", .label = "Top view", .help = "Look along -Y.",
         .shortcut = {GLFW_KEY_KP_7},
         .execute = [](Application& app) { viewAlong(app.workspace_.edit.camera, {0.0, 1.0, 0.0}); }},
        {.command = Command::FlyMode, .menu = "Camera", .label = "Fly",
         .help = "Drag to look around, W A S D Q E to move, wheel for the speed.",
         .shortcut = {GLFW_KEY_GRAVE_ACCENT},
         .alternatives = {{{GLFW_KEY_GRAVE_ACCENT, kShift}}}, .separatorBefore = true,
         .execute = [](Application& app) { toggle(app.workspace_.view.flying); },
         .checked = [](const Workspace& w) { return w.view.flying; }},

        {.command = Command::RecordRays, .menu = "Rays", .label = "Record rays",
         .help = "Record and draw the rays of the pixel under the cursor.",
         .shortcut = {GLFW_KEY_R}, .execute = perform<&Application::recordRays>},
        {.command = Command::ClearRays, .menu = "Rays", .label = "Clear rays",
         .help = "Discard the recorded rays.",
         .shortcut = {GLFW_KEY_C}, .alternatives = {{{GLFW_KEY_R, kShift}}},
         .execute = [](Application& app) { app.workspace_.rays.clear(); },
         .enabled = [](const Workspace& w) { return w.rays.recording() != nullptr; }},
        {.command = Command::ToggleLiveRay, .menu = "Rays", .label = "Live ray",
         .help = "Keep recording the pixel under the cursor as it moves.",
         .shortcut = {GLFW_KEY_L},
         .execute = [](Application& app) { toggle(app.workspace_.view.liveRay); },
         .checked = [](const Workspace& w) { return w.view.liveRay; }},
        {.command = Command::PinPixel, .menu = "Rays", .label = "Pin pixel",
         .help = "Keep the statistics of the recorded pixel for comparison.",
         .shortcut = {GLFW_KEY_P},
         .execute = [](Application& app) { app.workspace_.rays.pin(); },
         .enabled = [](const Workspace& w) { return w.rays.recording() != nullptr; }},
        {.command = Command::HideRay, .menu = "Rays", .label = "Hide", .help = "Do not draw the selected ray.",
         .shortcut = {GLFW_KEY_H}, .separatorBefore = true,
         .execute = [](Application& app) { app.workspace_.rays.hideSelected(); },
         .enabled = [](const Workspace& w) { return !w.rays.selection().empty(); }},
        {.command = Command::IsolateRay, .menu = "Rays", .label = "Isolate",
         .help = "Draw only the selected ray, its ancestors and its shadow rays.",
         .shortcut = {GLFW_KEY_I},
         .execute = [](Application& app) { toggle(app.workspace_.rays.filter.isolated); },
         .enabled = [](const Workspace& w) { return !w.rays.selection().empty(); },
         .checked = [](const Workspace& w) { return w.rays.filter.isolated; }},
        {.command = Command::CopyRays, .menu = "Rays", .label = "Copy as JSON",
         .help = "Copy the ray tree of the selected sample as JSON.",
         .shortcut = {GLFW_KEY_J},
         .execute = perform<&Application::copyRays>,
         .enabled = [](const Workspace& w) { return w.rays.recording() != nullptr; }},
        {.command = Command::ExportRays, .menu = "Rays", .label = "Export",
         .help = "Write the rays as OBJ lines and as JSON to the current folder.",
         .shortcut = {GLFW_KEY_J, kCtrl},
         .execute = perform<&Application::exportRays>,
         .enabled = [](const Workspace& w) { return w.rays.recording() != nullptr; }},
        {.command = Command::ToggleTraversal, .menu = "Rays", .label = "BVH traversal",
         .help = "Show the boxes that the selected ray visits, culls and misses.",
         .shortcut = {GLFW_KEY_T}, .separatorBefore = true,
         .execute = [](Application& app) { toggle(app.workspace_.rays.traversal.shown); },
         .checked = [](const Workspace& w) { return w.rays.traversal.shown; }},
        {.command = Command::StepForward, .menu = "Rays", .label = "Step forward",
         .help = "Advance the traversal by one step.",
         .shortcut = {GLFW_KEY_RIGHT}, .execute = [](Application& app) { app.workspace_.rays.step(1); }},
        {.command = Command::StepBack, .menu = "Rays", .label = "Step back",
         .help = "Go back one step of the traversal.",
         .shortcut = {GLFW_KEY_LEFT}, .execute = [](Application& app) { app.workspace_.rays.step(-1); }},
        {.command = Command::JumpForward, .menu = "Rays", .label = "Ten steps forward",
         .help = "Advance the traversal by ten steps.",
         .shortcut = {GLFW_KEY_RIGHT, kShift},
         .execute = [](Application& app) { app.workspace_.rays.step(10); }},
        {.command = Command::JumpBack, .menu = "Rays", .label = "Ten steps back",
         .help = "Go back ten steps of the traversal.",
         .shortcut = {GLFW_KEY_LEFT, kShift},
         .execute = [](Application& app) { app.workspace_.rays.step(-10); }},
        {.command = Command::Cancel, .menu = "Rays", .label = "Cancel",
         .help = "Cancel loading or close the open window, else leave fly mode or the live ray, else clear the rays.",
         .shortcut = {GLFW_KEY_ESCAPE}, .execute = perform<cancel>},

        {.command = Command::ToggleBvhLevels, .menu = "BVH", .label = "Boxes of a level",
         .help = "Show or hide the boxes of one level of the BVH.",
         .shortcut = {GLFW_KEY_B},
         .execute = [](Application& app) { toggle(app.workspace_.bvh.shown.levels); },
         .checked = [](const Workspace& w) { return w.bvh.shown.levels; }},
        {.command = Command::NextLevel, .menu = "BVH", .label = "Next level",
         .help = "Show the boxes one level deeper.",
         .shortcut = {GLFW_KEY_PAGE_DOWN},
         .execute = [](Application& app) { app.workspace_.bvh.stepLevel(1); }},
        {.command = Command::PreviousLevel, .menu = "BVH", .label = "Previous level",
         .help = "Show the boxes one level higher.",
         .shortcut = {GLFW_KEY_PAGE_UP}, .execute = [](Application& app) { app.workspace_.bvh.stepLevel(-1); }},
        {.command = Command::NextLeaf, .menu = "BVH", .label = "Next leaf",
         .help = "Highlight the next leaf and its primitives.",
         .shortcut = {GLFW_KEY_PERIOD}, .separatorBefore = true,
         .execute = [](Application& app) { app.workspace_.bvh.stepLeaf(1); }},
        {.command = Command::PreviousLeaf, .menu = "BVH", .label = "Previous leaf",
         .help = "Highlight the previous leaf and its primitives.",
         .shortcut = {GLFW_KEY_COMMA}, .execute = [](Application& app) { app.workspace_.bvh.stepLeaf(-1); }},
        {.command = Command::LeafUnderCursor, .menu = "BVH", .label = "Leaf under the cursor",
         .help = "Select the leaf of the primitive under the cursor.",
         .shortcut = {GLFW_KEY_G}, .execute = perform<selectLeafUnderCursor>},

        {.command = Command::ShowKeys, .menu = "Help", .label = "Keys",
         .help = "List keys and mouse gestures.",
         .shortcut = {GLFW_KEY_F1}, .alternatives = {{{GLFW_KEY_SLASH, kShift}}},
         .execute = [](Application& app) { toggle(app.workspace_.view.showKeys); },
         .checked = [](const Workspace& w) { return w.view.showKeys; }},
        {.command = Command::ShowStatistics, .menu = "Help", .label = "Statistics",
         .help = "Show frame times and ray counts.",
         .shortcut = {GLFW_KEY_F2},
         .execute = [](Application& app) { toggle(app.workspace_.view.showStatistics); },
         .checked = [](const Workspace& w) { return w.view.showStatistics; }},
    };
    // clang-format on

    static constexpr bool isComplete() {
        if (std::size(kRows) != static_cast<std::size_t>(Command::Count)) return false;
        for (std::size_t i = 0; i < std::size(kRows); ++i)
            if (kRows[i].command != static_cast<Command>(i) || kRows[i].execute == nullptr) return false;
        return true;
    }
};
static_assert(CommandTable::isComplete(),
              "each command has a row with a function, in the order of the enumeration");

std::span<const CommandInfo> commandTable() { return CommandTable::kRows; }

}  // namespace rayscope::viewer
