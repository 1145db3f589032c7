#include "viewer/jobs/scene_loader.h"

#include "base/memory_budget.h"

namespace rayscope::viewer {

LoadedScene loadWithNotes(const std::string& path, bool reload, const LoadControl& control) {
    const auto start = std::chrono::steady_clock::now();
    LoadedScene loaded{.path = path, .scene = {}, .bounds = {}, .notes = {}, .error = {}, .reload = reload};
    try {
        loaded.scene = loadScene(path, loaded.notes, control);
        loaded.bounds = boundsOf(*loaded.scene, control);
        const Diagnostics odd = lint(*loaded.scene, loaded.notes, control);
        loaded.notes.insert(loaded.notes.end(), odd.begin(), odd.end());
    } catch (const Stopped&) {
        throw;
    } catch (const std::bad_alloc& error) {
        loaded.error = path + ": error: " + base::messageOf(error);
    } catch (const std::exception& error) {
        loaded.error = error.what();
    }
    if (!loaded.error.empty()) loaded.scene.reset();
    loaded.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return loaded;
}

void SceneLoader::start(const std::string& path, bool reload) {
    path_ = path;
    cancelled_ = false;
    startedAt_ = std::chrono::steady_clock::now();
    step_ = std::make_shared<SharedStep>();
    job_.start([path, reload, shared = step_](const std::stop_token& stop, JobProgress&) {
        const auto show = [&shared](const std::string& name, double fraction) {
            const std::scoped_lock lock(shared->mutex);
            shared->step = {name, fraction};
        };
        return loadWithNotes(path, reload, {.progress = show, .stop = stop});
    });
}

void SceneLoader::cancel() {
    job_.discard();
    cancelled_ = true;
}

SceneLoader::Step SceneLoader::step() const {
    if (!step_) return {};
    const std::scoped_lock lock(step_->mutex);
    return step_->step;
}

}  // namespace rayscope::viewer
