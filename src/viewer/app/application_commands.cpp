// What each command of the table does.
#include <fmt/format.h>

#include <rayscope/display.h>
#include <rayscope/render_image.h>
#include <algorithm>
#include <cmath>

#include "viewer/app/application.h"
#include "viewer/model/camera_controller.h"
#include "viewer/model/camera_text.h"

namespace rayscope::viewer {

void Application::execute(Command command) {
    ViewState& view = workspace_.view;
    CameraDescription& camera = workspace_.edit.camera;
    const glm::ivec2 size = workspace_.viewSize;
    switch (command) {
        case Command::OpenScene:
            workspace_.openDialogRequested = true;
            break;
        case Command::ReloadScene:
            workspace_.loader.start(workspace_.edit.scene->path, true);
            break;
        case Command::SaveImage:
            saveImage();
            break;
        case Command::SaveScreenshot:
            screenshotRequested_ = true;
            break;
        case Command::RenderToFile:
            workspace_.renderDialogRequested = true;
            break;
        case Command::Quit:
            window_.close();
            break;
        case Command::Undo:
            workspace_.undo();
            break;
        case Command::Redo:
            workspace_.redo();
            break;
        case Command::CopyPixel:
            copyPixel();
            break;
        case Command::CopyCamera:
            window_.copyText(toOptions(camera));
            workspace_.notify("Copied: " + toOptions(camera));
            break;
        case Command::SwitchView:
            view.traced = !view.traced;
            break;
        case Command::RecordRays:
            recordRequested_ = true;
            break;
        case Command::ClearRays:
            workspace_.rays.clear();
            break;
        case Command::ToggleOverlay:
            view.overlay = !view.overlay;
            break;
        case Command::ToggleWireframe:
            view.raster.wireframe = !view.raster.wireframe;
            break;
        case Command::ToggleSidePanel:
            view.sidePanel = !view.sidePanel;
            break;
        case Command::ToggleFullScreen:
            window_.toggleFullScreen();
            break;
        case Command::IncreaseUiScale:
            setScale(view.scale + 0.25f);
            break;
        case Command::DecreaseUiScale:
            setScale(view.scale - 0.25f);
            break;
        case Command::ResetUiScale:
            setScale(window_.contentScale());
            break;
        case Command::PauseOrResume:
            workspace_.render.togglePause();
            break;
        case Command::ResetCamera:
            camera = initialState(*workspace_.edit.scene).camera;
            break;
        case Command::FrameAll:
            frameAll(camera, picture_.sceneBounds(), static_cast<double>(size.x) / size.y);
            break;
        case Command::FlyMode:
            view.flying = !view.flying;
            break;
        case Command::FrontView:
            viewAlong(camera, {0.0, 0.0, 1.0});
            break;
        case Command::SideView:
            viewAlong(camera, {1.0, 0.0, 0.0});
            break;
        case Command::TopView:
            viewAlong(camera, {0.0, 1.0, 0.0});
            break;
        case Command::ShowKeys:
            view.showKeys = !view.showKeys;
            break;
        case Command::ShowStatistics:
            view.showStatistics = !view.showStatistics;
            break;
        case Command::Cancel:
            if (view.showKeys)
                view.showKeys = false;
            else if (view.flying)
                view.flying = false;
            else if (view.liveRay)
                view.liveRay = false;
            else
                workspace_.rays.clear();
            break;
        default:
            executeDebugCommand(command);
            break;
    }
}

/// As soon as the world of what is shown is compiled; until then the viewRequest stays.
void Application::recordRays() {
    if (!workspace_.cursor || workspace_.render.status().state == RenderState::Failed) {
        recordRequested_ = false;
        return;
    }
    const auto world = workspace_.render.currentWorld();
    if (!world || input_.moving()) return;
    recordRequested_ = false;
    const glm::ivec2 pixel = workspace_.cursor->pixel;
    // A live ray has to keep up with the hand: it is neither verified nor replayed in full.
    const bool live = workspace_.view.liveRay;
    const auto film = workspace_.view.traced && !live ? workspace_.render.session().film() : nullptr;
    workspace_.rays.maxSamples = live ? DebugRays::kMaxLiveSamples : DebugRays::kMaxSamples;
    workspace_.rays.recordPixel(world, workspace_.edit, workspace_.imageSize(), {pixel.x, pixel.y, 0},
                                film.get());
    workspace_.view.overlay = true;
}

void Application::saveImage() {
    const std::string path = nextFreeName();
    try {
        const ImageMetadata metadata =
            metadataOf(workspace_.edit, 0, workspace_.view.traced ? workspace_.render.status().samples : 0);
        const auto film = workspace_.render.session().film();
        if (workspace_.view.traced && film)
            writeRenderedImage(path, meanOf(*film), workspace_.edit.settings, metadata);
        else
            writeImage(path, picture_.rasterImage(workspace_), metadata, Encoding::Srgb);
        workspace_.notify("Saved " + path);
    } catch (const InputError& error) {
        workspace_.errorMessage = error.what();
    }
}

void Application::saveScreenshotNow() {
    const std::string path = nextFreeName();
    const glm::ivec2 size = window_.framebufferSize();
    ImageMetadata metadata = metadataOf(workspace_.edit, 0, 0);
    if (const std::string lacking = drawnText(picture_.counts()); !lacking.empty())
        metadata["drawn"] = lacking;
    try {
        writeImage(path, readFramebuffer(0, 0, size.x, size.y), metadata, Encoding::Srgb);
        workspace_.notify("Saved " + path);
    } catch (const InputError& error) {
        workspace_.errorMessage = error.what();
    }
}

void Application::copyPixel() {
    if (!workspace_.cursor) return;
    const CursorInfo& cursor = *workspace_.cursor;
    std::string words = fmt::format("--pixel {},{}", cursor.pixel.x, cursor.pixel.y);
    if (cursor.radiance)
        words += fmt::format("  rgb {} {} {}", cursor.radiance->r, cursor.radiance->g, cursor.radiance->b);
    if (!cursor.object.empty()) words += "  " + cursor.object;
    if (cursor.triangle >= 0) words += fmt::format(", triangle {}", cursor.triangle);
    window_.copyText(words);
    workspace_.notify("Copied: " + words);
}

void Application::setScale(float scale) { workspace_.view.scale = std::clamp(scale, 1.0f, 4.0f); }

}  // namespace rayscope::viewer
