// What the commands of the menus Rays and BVH do.
#include <fmt/format.h>

#include <utility>

#include "base/atomic_file.h"
#include "viewer/app/application.h"

namespace rayscope::viewer {

void Application::executeDebugCommand(Command command) {
    BvhInspector& bvh = workspace_.bvh;
    DebugRays& rays = workspace_.rays;
    switch (command) {
        case Command::ToggleBvhLevels:
            bvh.shown.levels = !bvh.shown.levels;
            break;
        case Command::NextLevel:
            bvh.stepLevel(1);
            break;
        case Command::PreviousLevel:
            bvh.stepLevel(-1);
            break;
        case Command::NextLeaf:
            bvh.stepLeaf(1);
            break;
        case Command::PreviousLeaf:
            bvh.stepLeaf(-1);
            break;
        case Command::LeafUnderCursor:
            cursorCommands_.push_back(command);
            break;
        case Command::ToggleTraversal:
            rays.traversal.shown = !rays.traversal.shown;
            break;
        case Command::StepForward:
            rays.step(1);
            break;
        case Command::StepBack:
            rays.step(-1);
            break;
        case Command::JumpForward:
            rays.step(10);
            break;
        case Command::JumpBack:
            rays.step(-10);
            break;
        case Command::ToggleLiveRay:
            workspace_.view.liveRay = !workspace_.view.liveRay;
            break;
        case Command::ToggleHeatMap:
            workspace_.heat.shown = !workspace_.heat.shown;
            workspace_.view.traced |= workspace_.heat.shown;
            break;
        case Command::KeepPicture:
            keepPicture();
            break;
        case Command::ComparePictures:
            workspace_.comparison.view.shown = !workspace_.comparison.view.shown;
            workspace_.view.traced |= workspace_.comparison.visible();
            break;
        case Command::FlipPictures:
            workspace_.comparison.view.mode = CompareMode::Flip;
            workspace_.comparison.view.flipped = !workspace_.comparison.view.flipped;
            break;
        case Command::PinPixel:
            rays.pin();
            break;
        case Command::HideRay:
            rays.hideSelected();
            break;
        case Command::IsolateRay:
            rays.filter.isolated = !rays.filter.isolated;
            break;
        case Command::CopyRays:
            copyRays();
            break;
        case Command::ExportRays:
            exportRays();
            break;
        default:
            break;
    }
}

/// A coarse picture is of no use for a comparison.
void Application::keepPicture() {
    const RgbImage& image = picture_.shownImage();
    const bool whole = glm::ivec2(image.width, image.height) == workspace_.imageSize();
    if (!workspace_.view.traced || !whole || !workspace_.render.currentWorld()) {
        workspace_.notify("There is no traced picture to keep yet", Severity::Warning);
        return;
    }
    const int samples = workspace_.render.status().samples;
    workspace_.comparison.keep(workspace_.edit, image, samples);
    workspace_.comparison.view.shown = true;
    workspace_.notify(fmt::format("Kept as A: {} samples per pixel", samples));
}

void Application::copyRays() {
    const DebugRays::PixelRecording* recording = workspace_.rays.recording();
    if (recording == nullptr) return;
    window_.copyText(toJson(recording->tree(), *recording->world));
    workspace_.notify(fmt::format("Copied {} rays as JSON",
                                  recording->tree().nodes.size() + recording->tree().shadowRays.size()));
}

void Application::exportRays() {
    const DebugRays::PixelRecording* recording = workspace_.rays.recording();
    if (recording == nullptr) return;
    const std::string lines = nextFreeName(".obj"), tree = nextFreeName(".json");
    const SceneBounds& bounds = picture_.sceneBounds();
    try {
        base::writeFileAtomically(lines, toObj(recording->tree(), glm::distance(bounds.lower, bounds.upper)));
        base::writeFileAtomically(tree, toJson(recording->tree(), *recording->world));
        workspace_.notify("Saved " + lines + " and " + tree);
    } catch (const InputError& error) {
        workspace_.errorMessage = error.what();
    }
}

/// Once it is known what the cursor is on: it may have moved in the same frame in which the key went down.
void Application::executeAtCursor() {
    for (const Command command : std::exchange(cursorCommands_, {})) {
        if (!workspace_.cursor) continue;
        const CursorInfo& cursor = *workspace_.cursor;
        if (command == Command::LeafUnderCursor && cursor.primitive != kNoPrimitive)
            workspace_.bvh.selectLeafOf(
                workspace_.render.session().world()->locatePrimitive(cursor.primitive).inGroup);
    }
    const std::optional<CursorInfo>& cursor = workspace_.cursor;
    if (workspace_.view.liveRay && cursor && !input_.moving()) {
        const DebugRays::PixelRecording* recording = workspace_.rays.recording();
        const bool same = recording &&
                          glm::ivec2(recording->tree().name.x, recording->tree().name.y) == cursor->pixel &&
                          !workspace_.rays.isStaleFor(workspace_.edit, workspace_.imageSize());
        recordRequested_ |= !same;
    }
    if (recordRequested_) recordRays();
}

}  // namespace rayscope::viewer
