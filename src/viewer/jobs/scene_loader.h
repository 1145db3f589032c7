#pragma once
#include <rayscope/scene.h>
#include <future>
#include <optional>
#include <string>

namespace rayscope::viewer {

/// What came of opening a scene: `scene` and what the reader and the lint found odd, or the reason why not.
struct LoadedScene {
    std::string path;
    std::optional<SceneDescription> scene;
    Diagnostics notes;
    std::string error;
    bool reload = false;  ///< the camera, the settings and the view should stay as they are
    double seconds = 0.0;
};

/// Loads now.
LoadedScene loadWithNotes(const std::string& path, bool reload);

/// Loads in the background so that the window goes on; of several wishes the latest wins.
class SceneLoader {
  public:
    void start(const std::string& path, bool reload);
    /// The result, once, as soon as there is one.
    std::optional<LoadedScene> poll();
    bool busy() const { return pending_.valid(); }
    const std::string& path() const { return path_; }

  private:
    struct LoadRequest {
        std::string path;
        bool reload;
    };
    std::future<LoadedScene> pending_;
    std::optional<LoadRequest> next_;
    std::string path_;
};

}  // namespace rayscope::viewer
