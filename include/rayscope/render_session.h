#pragma once
#include <rayscope/image.h>
#include <rayscope/scene.h>
#include <rayscope/settings.h>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace rayscope {

namespace trace {
class World;
}
namespace render {
class Film;
}

/// Half-open rectangle of pixels: x0 <= x < x1, y0 <= y < y1, from the top left corner.
struct PixelBounds {
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    bool operator==(const PixelBounds&) const = default;
};

/// Everything an image is a function of, and how it should be delivered.
struct RenderRequest {
    std::shared_ptr<const SceneDescription> scene;
    Settings settings;
    CameraDescription camera;
    int width = 800, height = 800;
    std::optional<PixelBounds> region;  ///< absent: the whole image
    std::uint64_t seed = 0;
    bool keepBinaryTrees = true;  ///< so that hierarchies can be looked at; rays do not need them
    bool progressive = true;      ///< passes of 1, 1, 2, 4, 8 … samples instead of large ones; same bits
};

enum class RenderState { Idle, Compiling, Rendering, Paused, Done, Failed };

struct RenderStatus {
    RenderState state = RenderState::Idle;
    std::uint64_t epoch = 0;  ///< counts submissions; images of an older epoch are never delivered
    int samples = 0;          ///< per pixel, that every pixel has
    int targetSamples = 0;
    double progress = 0.0;          ///< 0 … 1
    double elapsedSeconds = 0.0;    ///< tracing only
    double remainingSeconds = 0.0;  ///< estimate; 0 when unknown
    double compileSeconds = 0.0, buildSeconds = 0.0;
    double sahCostGrowth = 1.0;  ///< how many times as dear refits have made the hierarchies, by the SAH
    std::uint64_t rays = 0;      ///< traced so far, of all kinds
    std::uint64_t nonFiniteSamples = 0;
    std::string message;  ///< why it failed
};

/// Pixels of one tile that changed: means so far, linear, `stride` pixels per row.
struct TileView {
    int x0, y0, width, height;
    int imageWidth, imageHeight;  ///< of the image that the tile belongs to
    int samples;
    std::span<const Rgb> mean;  ///< width * height, row by row
};

/// Renders in the background. The caller never waits: submit() returns at once and the latest request wins.
/// The film always holds a valid image; what a new request does not invalidate is kept. All functions may be
/// called from one thread at a time, except that the session's own threads run beside it.
class RenderSession {
  public:
    /// `threads` counts the tracing threads; 0 takes one per core.
    explicit RenderSession(int threads = 0);
    ~RenderSession();
    RenderSession(const RenderSession&) = delete;
    RenderSession& operator=(const RenderSession&) = delete;

    void submit(RenderRequest request);
    void pause();
    void resume();
    void cancel();  ///< at once; keeps the film, and a later submit() of the same request goes on from it
    void finishTiles();  ///< like cancel(), but tiles in flight are completed first

    RenderStatus status() const;
    /// Calls `take` for tiles that changed since the last call, until all are taken or `budgetSeconds` are
    /// spent. Returns the number of tiles delivered.
    int collect(const std::function<void(const TileView&)>& take, double budgetSeconds = 1e9);
    /// Blocks until the present request is done, failed or cancelled, or `seconds` have passed. Returns the
    /// state.
    RenderState wait(double seconds = 1e9);

    std::shared_ptr<const trace::World> world() const;  ///< null until compiled
    std::shared_ptr<const render::Film> film() const;   ///< null until compiled

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rayscope
