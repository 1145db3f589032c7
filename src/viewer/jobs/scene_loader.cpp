#include "viewer/jobs/scene_loader.h"

#include <chrono>
#include <utility>

namespace rayscope::viewer {

LoadedScene loadWithNotes(const std::string& path, bool reload) {
    const auto start = std::chrono::steady_clock::now();
    LoadedScene loaded{.path = path, .scene = {}, .notes = {}, .error = {}, .reload = reload};
    try {
        loaded.scene = loadScene(path, loaded.notes);
        const Diagnostics odd = lint(*loaded.scene);
        loaded.notes.insert(loaded.notes.end(), odd.begin(), odd.end());
    } catch (const std::exception& error) {
        loaded.error = error.what();
    }
    loaded.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return loaded;
}

void SceneLoader::start(const std::string& path, bool reload) {
    if (running_.valid()) {
        next_ = Wish{path, reload};
        return;
    }
    path_ = path;
    running_ = std::async(std::launch::async, loadWithNotes, path, reload);
}

std::optional<LoadedScene> SceneLoader::poll() {
    if (!running_.valid() || running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    LoadedScene loaded = running_.get();
    if (!next_) return loaded;
    const Wish wish = *std::exchange(next_, std::nullopt);
    start(wish.path, wish.reload);
    return std::nullopt;
}

}  // namespace rayscope::viewer
