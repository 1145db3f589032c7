#pragma once
// Pictures on their way to files.
#include <rayscope/render_session.h>
#include <future>
#include <string>

#include "viewer/model/edit_state.h"

namespace rayscope::viewer {

/// The first of rayscope-0001, rayscope-0002 … with this suffix that does not exist in the current folder.
std::string nextFreeName(std::string_view suffix = ".png");

/// What travels inside a saved image.
ImageMetadata metadataOf(const EditState& state, std::uint64_t seed, int samples);

/// Pixels of the bound framebuffer, whose rows start at the bottom, as a linear image.
RgbImage readFramebuffer(int x, int y, int width, int height);

/// A render to a file in its own session, beside the window.
class RenderJob {
  public:
    enum class Phase { Rendering, Writing, Done, Cancelled, Failed };

    /// Throws InputError if nothing could be written to `path`.
    RenderJob(const EditState& state, int width, int height, std::string path, int threads);

    /// Moves on from rendering to writing to done; to be called in each frame.
    void update();
    void cancel();

    Phase phase() const { return phase_; }
    bool running() const { return phase_ == Phase::Rendering || phase_ == Phase::Writing; }
    RenderStatus status() const { return session_.status(); }
    const std::string& path() const { return path_; }
    const std::string& error() const { return error_; }

  private:
    EditState state_;
    std::string path_, error_;
    RenderSession session_;
    std::future<void> writing_;
    Phase phase_ = Phase::Rendering;
};

}  // namespace rayscope::viewer
