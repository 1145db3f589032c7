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
                            !workspace_.rays.isStaleFor(workspace_.edit, workspace_.imageSize());
    if (!isRecorded) commands.push_back(Command::RecordRays);
}

void Application::recordRays() {
    if (!workspace_.cursor || workspace_.render.status().state == RenderState::Failed) return;
    const auto world = workspace_.render.currentWorld();
    if (!world || input_.moving()) {
        // Retry in the next frame, until the world is compiled.
        workspace_.picked = workspace_.cursor;
        workspace_.commands.push_back(Command::RecordRays);
        return;
    }
    const glm::ivec2 pixel = workspace_.cursor->pixel;
    // A live ray follows the cursor, so it is not verified, and few samples are replayed.
    const bool live = workspace_.view.liveRay;
    auto film = workspace_.view.traced && !live ? workspace_.render.session().film() : nullptr;
    workspace_.rays.maxSamples = live ? DebugRays::kMaxLiveSamples : DebugRays::kMaxSamples;
    workspace_.rays.recordPixel(world, workspace_.edit, workspace_.imageSize(), {pixel.x, pixel.y, 0},
                                std::move(film));
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
    const ImageMetadata metadata =
        metadataOf(workspace_.edit, workspace_.view.traced ? workspace_.render.status().samples : 0);
    const auto film = workspace_.render.session().film();
    if (workspace_.view.traced && film)
        workspace_.saves.add({path}, [path, film, settings = workspace_.edit.settings, metadata] {
            writeRenderedImage(path, meanOf(*film), settings, metadata);
        });
    else
        savePixels(path, picture_.rasterPixels(workspace_), metadata);
}

void Application::savePixels(const std::string& path, FramebufferPixels pixels,
                             const ImageMetadata& metadata) {
    workspace_.saves.add({path}, [path, pixels = std::move(pixels), metadata] {
        writeImage(path, linearImage(pixels), metadata, Encoding::Srgb);
    });
}

void Application::saveScreenshotNow() {
    const std::string path = workspace_.saves.nextFreeName();
    const glm::ivec2 size = window_.framebufferSize();
    ImageMetadata metadata = metadataOf(workspace_.edit, 0);
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

/// Previews are not kept.
void Application::keepPicture() {
    const RgbImage& image = picture_.shownImage();
    const bool whole = glm::ivec2(image.width, image.height) == workspace_.imageSize();
    if (!workspace_.view.traced || !whole || !workspace_.render.currentWorld()) {
        workspace_.notify("No traced picture at full resolution yet: show the ray-traced view and try again",
                          Severity::Warning);
        return;
    }
    const int samples = workspace_.render.status().samples;
    workspace_.comparison.keep(workspace_.edit, image, samples);
    workspace_.comparison.view.shown = true;
    workspace_.notify(fmt::format("Kept as A with {} samples per pixel", samples));
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
