#pragma once
#include <rayscope/scene.h>
#include <optional>
#include <string>

#include "viewer/jobs/background_job.h"

namespace rayscope::viewer {

/// The result of opening a scene: `scene` with the notes of reader and lint, or `error`.
struct LoadedScene {
    std::string path;
    std::optional<SceneDescription> scene;
    Diagnostics notes;
    std::string error;
    bool reload = false;  ///< keep the camera, the settings and the view
    double seconds = 0.0;
};

/// Reads and checks a scene; does not throw.
LoadedScene loadWithNotes(const std::string& path, bool reload);

/// Loads scenes in the background; of several requests the latest wins.
class SceneLoader {
  public:
    void start(const std::string& path, bool reload);
    /// The result, once, as soon as there is one.
    std::optional<LoadedScene> poll() { return job_.poll(); }
    bool busy() const { return job_.busy(); }
    const std::string& path() const { return path_; }

  private:
    BackgroundJob<LoadedScene> job_;
    std::string path_;
};

}  // namespace rayscope::viewer
