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
    if (pending_.valid()) {
        next_ = LoadRequest{path, reload};
        return;
    }
    path_ = path;
    pending_ = std::async(std::launch::async, loadWithNotes, path, reload);
}

std::optional<LoadedScene> SceneLoader::poll() {
    if (!pending_.valid() || pending_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    LoadedScene loaded = pending_.get();
    if (!next_) return loaded;
    const LoadRequest loadRequest = *std::exchange(next_, std::nullopt);
    start(loadRequest.path, loadRequest.reload);
    return std::nullopt;
}

}  // namespace rayscope::viewer
