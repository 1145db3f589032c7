// What the commands of the menus Rays and BVH do.
#include <fmt/format.h>

#include <utility>

#include "base/atomic_file.h"
#include "viewer/app/application.h"

namespace rayscope::viewer {

void Application::carryOutDebugging(Command command) {
    BvhInspector& bvh = workspace_.bvh;
    DebugRays& rays = workspace_.rays;
    switch (command) {
        case Command::ToggleBvhLevels:
            bvh.shown.levels = !bvh.shown.levels;
            break;
        case Command::DeeperLevel:
            bvh.stepLevel(1);
            break;
        case Command::HigherLevel:
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
        case Command::ToggleSearch:
            rays.search.shown = !rays.search.shown;
            break;
        case Command::StepForward:
            rays.step(1);
            break;
        case Command::StepBack:
            rays.step(-1);
            break;
        case Command::LeapForward:
            rays.step(10);
            break;
        case Command::LeapBack:
            rays.step(-10);
            break;
        case Command::LiveRay:
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
    if (!workspace_.view.traced || !whole || !workspace_.render.settledWorld()) {
        workspace_.tell("There is no traced picture to keep yet", Severity::Warning);
        return;
    }
    const int samples = workspace_.render.status().samples;
    workspace_.comparison.keep(workspace_.edit, image, samples);
    workspace_.comparison.view.shown = true;
    workspace_.tell(fmt::format("Kept as A: {} samples per pixel", samples));
}

void Application::copyRays() {
    const DebugRays::Shot* shot = workspace_.rays.shot();
    if (shot == nullptr) return;
    window_.copyText(toJson(shot->tree(), *shot->world));
    workspace_.tell(
        fmt::format("Copied {} rays as JSON", shot->tree().nodes.size() + shot->tree().shadowRays.size()));
}

void Application::exportRays() {
    const DebugRays::Shot* shot = workspace_.rays.shot();
    if (shot == nullptr) return;
    const std::string lines = nextFreeName(".obj"), tree = nextFreeName(".json");
    const SceneBounds& bounds = picture_.sceneBounds();
    try {
        base::writeFileAtomically(lines, toObj(shot->tree(), glm::distance(bounds.lower, bounds.upper)));
        base::writeFileAtomically(tree, toJson(shot->tree(), *shot->world));
        workspace_.tell("Saved " + lines + " and " + tree);
    } catch (const InputError& error) {
        workspace_.errorMessage = error.what();
    }
}

/// Once it is known what the cursor is on: it may have moved in the same frame in which the key went down.
void Application::carryOutAtCursor() {
    for (const Command command : std::exchange(cursorCommands_, {})) {
        if (!workspace_.cursor) continue;
        const CursorInfo& cursor = *workspace_.cursor;
        if (command == Command::LeafUnderCursor && cursor.primitive != kNoPrimitive)
            workspace_.bvh.selectLeafOf(workspace_.render.session().world()->nameOf(cursor.primitive).inBody);
    }
    const std::optional<CursorInfo>& cursor = workspace_.cursor;
    if (workspace_.view.liveRay && cursor && !input_.moving()) {
        const DebugRays::Shot* shot = workspace_.rays.shot();
        const bool same = shot && glm::ivec2(shot->tree().name.x, shot->tree().name.y) == cursor->pixel &&
                          !workspace_.rays.staleFor(workspace_.edit, workspace_.imageSize());
        rayWanted_ |= !same;
    }
    if (rayWanted_) shootRay();
}

}  // namespace rayscope::viewer
