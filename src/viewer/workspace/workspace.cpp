#include "viewer/workspace/workspace.h"

#include <fmt/format.h>

#include <rayscope/save_scene.h>

#include <algorithm>
#include <filesystem>

#include "viewer/model/camera_controller.h"

namespace rayscope::viewer {

namespace {

std::string currentFolder() {
    std::error_code failed;
    const std::filesystem::path folder = std::filesystem::current_path(failed);
    return failed ? "the current folder" : folder.string();
}

}  // namespace

Workspace::Workspace(EditState first, Diagnostics firstNotes, int threads)
    : edit(std::move(first)), history(edit), sceneNotes(std::move(firstNotes)), render(threads) {
    view.flySpeed = defaultFlySpeed(edit.bounds);
}

const SceneRequirements& Workspace::needs() {
    if (requirementsScene_ != edit.scene) {
        requirements_ = requirementsOf(*edit.scene);
        requirementsScene_ = edit.scene;
    }
    requirements_.lens = edit.camera.lens.has_value();
    return requirements_;
}

glm::ivec2 Workspace::imageSize() const {
    const glm::vec2 size = glm::round(glm::vec2(viewSize) * view.resolution);
    return glm::max(glm::ivec2(size), glm::ivec2(1));
}

std::shared_ptr<const trace::World> Workspace::worldOfScene() const {
    const std::optional<TracedPicture> picture = render.session().picture();
    return picture && picture->request().scene == edit.scene ? picture->world() : nullptr;
}

bool Workspace::busy() const {
    const bool exporting = job && job->running();
    const bool running[] = {render.busy(),     loader.busy(), rays.busy(),           bvh.busy(),
                            heat.busy(),       lab.busy(),    trade.busy(),          exporting,
                            comparison.busy(), saves.busy(),  shown.computingBloom()};
    return std::find(std::begin(running), std::end(running), true) != std::end(running);
}

void Workspace::notify(std::string text, Severity severity) { notice = Notice{std::move(text), severity}; }

void Workspace::setLights(std::vector<Light> lights) {
    edit.scene = withLights(*edit.scene, std::move(lights));
    view.selectedLight = std::min(view.selectedLight, static_cast<int>(edit.scene->lights.size()) - 1);
}

void Workspace::cancelLoading() {
    if (!loader.loading()) return;
    loader.cancel();
    notify(fmt::format("Cancelled: {} was not loaded", loader.path()), Severity::Warning);
}

void Workspace::reportSaves() {
    while (const auto outcome = saves.poll()) {
        if (outcome->error.empty())
            notify(fmt::format("Saved {} in {}", outcome->names, currentFolder()));
        else
            errorMessage = outcome->error;
    }
}

void Workspace::show(LoadedScene loaded, const RequestOverrides* overrides) {
    if (!loaded.scene) {
        errorMessage = loaded.error;
        return;
    }
    try {
        EditState opened = initialState(std::move(*loaded.scene), overrides ? *overrides : RequestOverrides{},
                                        loaded.bounds);
        if (loaded.reload) {
            opened.settings = edit.settings;
            opened.camera = edit.camera;
        }
        edit = std::move(opened);
    } catch (const InputError& error) {
        if (overrides) throw;
        errorMessage = error.what();
        return;
    }
    if (overrides) history = History(edit);
    sceneNotes = std::move(loaded.notes);
    if (!loaded.reload) {
        view.selectedLight = -1;
        bvh.clearSelection();
    }
    view.flySpeed = defaultFlySpeed(edit.bounds);
    record();
    recent.add(loaded.path);
    if (!overrides) notify(fmt::format("Opened {} in {:.2f} s", loaded.path, loaded.seconds));
}

bool Workspace::awaitPixel(const CommandInfo& info) {
    if (!info.needsPixel) return false;
    if (view.picking == info.command) view.picking.reset();
    if (!cursor) view.picking = info.command;
    return !cursor;
}

void Workspace::record() {
    if (!history.record(edit)) return;
    // Steps of the discarded branch.
    std::erase_if(undoneByUndo_,
                  [this](const RaysStep& step) { return step.position >= history.position(); });
    undoneByRedo_.clear();
}

bool Workspace::raysStepIsLast(const RaysSteps& steps) const {
    return !steps.empty() && steps.back().position == history.position();
}

void Workspace::changeRays(DebugRays::Shown wanted) {
    undoneByUndo_.push_back({history.position(), rays.exchange(std::move(wanted))});
    if (undoneByUndo_.size() > kMaxRaysSteps) undoneByUndo_.erase(undoneByUndo_.begin());
    undoneByRedo_.clear();
}

void Workspace::exchangeRays(RaysSteps& from, RaysSteps& to) {
    RaysStep step = std::move(from.back());
    from.pop_back();
    to.push_back({step.position, rays.exchange(std::move(step.other))});
}

void Workspace::clearRays() {
    if (rays.recording() != nullptr) changeRays({.whole = true});
}

void Workspace::hideSelectedRay() {
    if (!rays.selection().empty()) changeRays(rays.withoutSelected());
}

void Workspace::showAllRays() {
    if (!rays.filter.hidden.empty()) changeRays({});
}

void Workspace::updateTracing(bool moving) {
    constexpr double kCollectSeconds = 0.006;  // per frame, of a frame time of 33 ms
    const glm::ivec2 size = imageSize();
    render.update({edit, size.x, size.y, moving, view.traced, stopCriteria});
    if (view.traced) shown.update(render, edit.settings, kCollectSeconds);
}

/// The traced picture of the current state at full size, with the display of its settings.
std::optional<StillPicture> Workspace::fullPicture() {
    if (!view.traced || !shown.isFull(edit, imageSize())) {
        notify("No traced picture at full resolution yet: show the ray-traced view and try again",
               Severity::Warning);
        return std::nullopt;
    }
    StillPicture picture = shown.source()->still();
    picture.setDisplay(edit.settings);
    return picture;
}

void Workspace::keepPicture() {
    std::optional<StillPicture> picture = fullPicture();
    if (!picture) return;
    notify(fmt::format("Kept as A with {} samples per pixel", samplesText(*picture)));
    comparison.keep(std::move(*picture));
    comparison.view.shown = true;
}

void Workspace::saveTracedPicture(const std::string& path) {
    std::optional<StillPicture> picture = fullPicture();
    if (picture) saves.add({path}, [path, picture = std::move(*picture)] { writePicture(path, picture); });
}

void Workspace::saveEditedScene() {
    const std::string path = saves.nextFreeName(".toml");
    saves.add({path}, [path, state = edit] { saveScene(sceneOf(state), path); });
}

std::string tracedNotice(const Workspace& workspace) {
    const bool heat = workspace.heat.image() != nullptr;
    if (!workspace.view.traced || heat) return "";
    const int mostSamples =
        workspace.stopCriteria.byError ? RenderControl::kMaxSamples : workspace.edit.settings.spp;
    return noticeOf(workspace.shown, workspace.edit, workspace.imageSize(), mostSamples);
}

void Workspace::undo() {
    if (raysStepIsLast(undoneByUndo_)) return exchangeRays(undoneByUndo_, undoneByRedo_);
    if (!history.canUndo()) return;
    edit = history.undo();
    view.selectedLight = std::min(view.selectedLight, static_cast<int>(edit.scene->lights.size()) - 1);
}

void Workspace::redo() {
    if (raysStepIsLast(undoneByRedo_)) return exchangeRays(undoneByRedo_, undoneByUndo_);
    if (!history.canRedo()) return;
    edit = history.redo();
    view.selectedLight = std::min(view.selectedLight, static_cast<int>(edit.scene->lights.size()) - 1);
}

}  // namespace rayscope::viewer
