#include "viewer/jobs/scene_loader.h"

#include <chrono>

namespace rayscope::viewer {

LoadedScene loadWithNotes(const std::string& path, bool reload) {
    const auto start = std::chrono::steady_clock::now();
    LoadedScene loaded{.path = path, .scene = {}, .notes = {}, .error = {}, .reload = reload};
    try {
        loaded.scene = loadScene(path, loaded.notes);
        const Diagnostics odd = lint(*loaded.scene, loaded.notes);
        loaded.notes.insert(loaded.notes.end(), odd.begin(), odd.end());
    } catch (const std::exception& error) {
        loaded.error = error.what();
    }
    loaded.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return loaded;
}

void SceneLoader::start(const std::string& path, bool reload) {
    path_ = path;
    job_.start([path, reload](const std::stop_token&, JobProgress&) { return loadWithNotes(path, reload); });
}

}  // namespace rayscope::viewer
