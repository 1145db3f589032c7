#pragma once
#include <rayscope/scene.h>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "viewer/jobs/background_job.h"

namespace rayscope::viewer {

/// The result of opening a scene: `scene` with its bounds and the notes of reader and lint, or `error`.
struct LoadedScene {
    std::string path;
    std::optional<SceneDescription> scene;
    SceneBounds bounds;
    Diagnostics notes;
    std::string error;
    bool reload = false;  ///< keep the camera, the settings and the view
    double seconds = 0.0;
};

/// Reads and checks a scene. Throws nothing but Stopped.
LoadedScene loadWithNotes(const std::string& path, bool reload, const LoadControl& control = {});

/// Loads scenes in the background; of several requests the latest wins.
class SceneLoader {
  public:
    void start(const std::string& path, bool reload);
    /// Ends the load; no result is delivered.
    void cancel();
    /// The result, once, as soon as there is one.
    std::optional<LoadedScene> poll() { return job_.poll(); }

    /// Whether a scene is being loaded that was not cancelled.
    bool loading() const { return job_.busy() && !cancelled_; }
    /// Whether any work runs; after cancel() it ends soon.
    bool busy() const { return job_.busy(); }
    const std::string& path() const { return path_; }
    /// The current step, e.g. "reading dragon.obj", and its progress 0 … 1.
    struct Step {
        std::string name;
        double fraction = 0.0;
    };
    Step step() const;
    /// Since start().
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - startedAt_).count();
    }

  private:
    /// Written by the thread of the load.
    struct SharedStep {
        std::mutex mutex;
        Step step;
    };

    BackgroundJob<LoadedScene> job_;
    std::string path_;
    std::shared_ptr<SharedStep> step_;
    std::chrono::steady_clock::time_point startedAt_{};
    bool cancelled_ = false;
};

}  // namespace rayscope::viewer
