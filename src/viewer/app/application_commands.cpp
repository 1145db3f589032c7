// Functions of commands that need the window or the picture.
#include <fmt/format.h>

#include <rayscope/display.h>
#include <rayscope/render_image.h>
#include <algorithm>
#include <utility>

#include "math/vectors.h"
#include "viewer/app/application.h"
#include "viewer/model/camera_controller.h"

namespace rayscope::viewer {

void Application::executeCommands() {
    if (auto picked = std::exchange(workspace_.picked, std::nullopt)) workspace_.cursor = std::move(picked);
    for (const Command command : std::exchange(workspace_.commands, {})) {
        const CommandInfo& info = infoOf(command);
        if (!workspace_.awaitPixel(info)) info.execute(*this);
    }
}

/// While the live ray is on, every change of the pixel under the cursor or of the picture records again.
void Application::requestLiveRay() {
    const std::optional<CursorInfo>& cursor = workspace_.cursor;
    std::vector<Command>& commands = workspace_.commands;
    if (!workspace_.view.liveRay || !cursor || input_.moving() ||
        std::find(commands.begin(), commands.end(), Command::RecordRays) != commands.end())
        return;
    const DebugRays::PixelRecording* recording = workspace_.rays.recording();
    const bool isRecorded = recording &&
                            glm::ivec2(recording->tree().name.x, recording->tree().name.y) == cursor->pixel &&
                            workspace_.rays.isOf(workspace_.edit, workspace_.imageSize());
    if (!isRecorded) commands.push_back(Command::RecordRays);
}

void Application::recordRays() {
    if (!workspace_.cursor || workspace_.render.status().state == RenderState::Failed) return;
    const std::optional<TracedPicture> picture = workspace_.render.currentPicture();
    if (!picture || input_.moving()) {
        // Retry in the next frame, until the world is compiled.
        workspace_.picked = workspace_.cursor;
        workspace_.commands.push_back(Command::RecordRays);
        return;
    }
    const glm::ivec2 pixel = workspace_.cursor->pixel;
    // A live ray follows the cursor, so it is not verified, and few samples are replayed.
    const bool live = workspace_.view.liveRay, compares = workspace_.view.traced && !live;
    workspace_.rays.maxSamples = live ? DebugRays::kMaxLiveSamples : DebugRays::kMaxSamples;
    workspace_.rays.recordPixel(*picture, workspace_.edit.settings.spp, {pixel.x, pixel.y, 0},
                                compares ? DebugRays::Compare::WithFilm : DebugRays::Compare::WithNothing);
    workspace_.view.overlay = true;
}

void Application::copyCamera() {
    const std::string options = toOptions(workspace_.edit.camera);
    window_.copyText(options);
    workspace_.notify("Copied: " + options);
}

void Application::frameScene() {
    const glm::dvec2 size(workspace_.viewSize);
    frameAll(workspace_.edit.camera, workspace_.edit.bounds, size.x / size.y);
}

void Application::saveImage() {
    const std::string path = workspace_.saves.nextFreeName();
    if (workspace_.view.traced)
        workspace_.saveTracedPicture(path);
    else
        savePixels(path, picture_.rasterPixels(workspace_), rasterMetadata());
}

/// The metadata of pixels that were not traced, or with overlays: the state, with 0 samples.
ImageMetadata Application::rasterMetadata() const { return metadataOf(requestOf(workspace_.edit, 1, 1), 0); }

void Application::savePixels(const std::string& path, FramebufferPixels pixels,
                             const ImageMetadata& metadata) {
    workspace_.saves.add({path}, [path, pixels = std::move(pixels), metadata] {
        writeImage(path, linearImage(pixels), metadata, Encoding::Srgb);
    });
}

void Application::saveScreenshotNow() {
    const std::string path = workspace_.saves.nextFreeName();
    const glm::ivec2 size = window_.framebufferSize();
    const RenderRequest* traced = workspace_.view.traced ? workspace_.shown.request() : nullptr;
    ImageMetadata metadata = traced ? metadataOf(*traced, workspace_.shown.leastSamples()) : rasterMetadata();
    if (const std::string notice = tracedNotice(workspace_); !notice.empty()) metadata["shown"] = notice;
    if (const std::string lacking = drawnText(picture_.counts()); !lacking.empty())
        metadata["drawn"] = lacking;
    savePixels(path, readFramebuffer(0, 0, size.x, size.y), metadata);
}

void Application::copyPixel() {
    if (!workspace_.cursor) return;
    const CursorInfo& cursor = *workspace_.cursor;
    std::string text = fmt::format("--pixel {},{}", cursor.pixel.x, cursor.pixel.y);
    if (cursor.radiance)
        text += fmt::format("  rgb {} {} {}", cursor.radiance->r, cursor.radiance->g, cursor.radiance->b);
    if (!cursor.object.empty()) text += "  " + cursor.object;
    if (cursor.triangle >= 0) text += fmt::format(", triangle {}", cursor.triangle);
    window_.copyText(text);
    workspace_.notify("Copied: " + text);
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
    const std::string lines = workspace_.saves.nextFreeName(".obj"),
                      json = workspace_.saves.nextFreeName(".json");
    const SceneBounds& bounds = workspace_.edit.bounds;
    const auto size = static_cast<float>(math::distance(bounds.lower, bounds.upper));
    workspace_.saves.add({lines, json},
                         [lines, json, size, tree = recording->tree(), world = recording->world] {
                             for (const std::string& path : {lines, json})
                                 writeRayTree(path, tree, *world, size);
                         });
}

/// In steps of 10 %.
void Application::setScale(float scale) {
    workspace_.view.scale =
        std::clamp(std::round(10.0f * scale) / 10.0f, WindowLayout::kMinScale, WindowLayout::kMaxScale);
}

void Application::chooseScale(float scale) {
    setScale(scale);
    layout_.scale = workspace_.view.scale;
}

}  // namespace rayscope::viewer
