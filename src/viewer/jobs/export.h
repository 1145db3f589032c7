#pragma once
// Writes pictures to files.
#include <rayscope/render_session.h>
#include <string>

#include "viewer/jobs/background_job.h"
#include "viewer/model/edit_state.h"

namespace rayscope::viewer {

/// Writes the picture with its metadata.
void writePicture(const std::string& path, const StillPicture& picture);

/// A render to a file, in the background and in a session of its own.
class RenderJob {
  public:
    enum class Phase { Rendering, Writing, Done, Cancelled, Failed };

    /// Throws InputError if nothing could be written to `path`.
    RenderJob(const EditState& state, int width, int height, std::string path, int threads);

    /// Updates phase(); to be called in each frame.
    void update();
    void cancel();

    Phase phase() const { return phase_; }
    bool running() const { return phase_ == Phase::Rendering || phase_ == Phase::Writing; }
    RenderStatus status() const { return session_.status(); }
    const std::string& path() const { return path_; }
    const std::string& error() const { return error_; }

  private:
    std::string path_, error_;
    RenderSession session_;
    BackgroundJob<bool> writing_;
    Phase phase_ = Phase::Rendering;
};

}  // namespace rayscope::viewer
