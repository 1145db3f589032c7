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
#include <utility>

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
    bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
    bool operator==(const PixelBounds&) const = default;
};

/// The inputs that determine an image, and options of the session.
struct RenderRequest {
    std::shared_ptr<const SceneDescription> scene;
    Settings settings;
    CameraDescription camera;
    int width = 800, height = 800;
    std::optional<PixelBounds> region;  ///< absent: the whole image
    std::uint64_t seed = 0;
    bool keepBinaryTrees = true;  ///< for the display of BVHs; rays do not need them
    bool progressive = true;  ///< passes of 1, 1, 2, 4, 8 … samples instead of 16; the image is the same
};

/// The largest number of threads of a session or any other computation.
inline constexpr int kMaxThreads = 1024;

/// Idle: nothing submitted yet, or cancelled.
enum class RenderState { Idle, Compiling, Rendering, Paused, Done, Failed };

struct RenderStatus {
    RenderState state = RenderState::Idle;
    std::uint64_t epoch = 0;  ///< number of submissions so far
    int samples = 0;          ///< per pixel, the minimum over the image
    int targetSamples = 0;
    double progress = 0.0;               ///< 0 … 1
    double elapsedSeconds = 0.0;         ///< spent on tracing the current film
    double remainingSeconds = 0.0;       ///< estimate; 0 when unknown
    double compileSeconds = 0.0;         ///< of the latest compilation
    double buildSeconds = 0.0;           ///< of its BVHs, also if an earlier compilation has built them
    double sahCostGrowth = 1.0;          ///< SAH cost after refits over that of the BVHs as built
    std::uint64_t rays = 0;              ///< traced for the current film, of all kinds
    std::uint64_t nonFiniteSamples = 0;  ///< NaN or infinite; they are part of the film
    std::string message;                 ///< the error, if the state is Failed
    bool outOfMemory = false;            ///< whether it failed for lack of memory
};

/// Pixels that do not change any more, with the request and the samples that made them.
class StillPicture {
  public:
    const RenderRequest& request() const { return request_; }
    /// Mean of the samples of each pixel, linear; 0 outside the region and where a pixel has no samples.
    const RgbImage& mean() const { return mean_; }
    /// Samples of the pixels that have the fewest and the most.
    int leastSamples() const { return leastSamples_; }
    int mostSamples() const { return mostSamples_; }
    /// Replaces the settings that apply to finished pixels (bloom, exposure, encoding) by those of
    /// `settings`; those that the pixels were traced with stay.
    void setDisplay(const Settings& settings);

  private:
    friend class TracedPicture;
    RenderRequest request_;
    RgbImage mean_;
    int leastSamples_ = 0, mostSamples_ = 0;
};

/// A film with the request and the compiled scene that it is traced with. Only a session makes one, so that
/// no film can be shown or written with the request of another. Copies share the film, which may still grow.
class TracedPicture {
  public:
    const RenderRequest& request() const { return request_; }
    const std::shared_ptr<const trace::World>& world() const { return world_; }
    const std::shared_ptr<const render::Film>& film() const { return film_; }
    /// A copy of the film as it is now. Its request asks for at least the samples that the film has, which
    /// are more than those of request() after a later request continued the film.
    StillPicture still() const;

  private:
    friend class RenderSession;
    TracedPicture(RenderRequest request, std::shared_ptr<const trace::World> world,
                  std::shared_ptr<const render::Film> film)
        : request_(std::move(request)), world_(std::move(world)), film_(std::move(film)) {}

    RenderRequest request_;
    std::shared_ptr<const trace::World> world_;
    std::shared_ptr<const render::Film> film_;
};

/// One tile: the mean of each pixel so far, linear.
struct TileView {
    const TracedPicture& picture;  ///< that the tile belongs to
    int x0, y0, width, height;
    int imageWidth, imageHeight;  ///< of the whole image
    int samples;
    std::span<const Rgb> mean;  ///< width * height, row by row
};

/// Renders in the background. submit() returns at once, and a new request replaces the current one. The film
/// is a valid image at any time. A request that differs only in a larger number of samples or in display
/// settings continues it; one for fewer samples than the film has starts another. Calls must come from one
/// thread at a time.
class RenderSession {
  public:
    /// `threads`: number of tracing threads, 0 … kMaxThreads; 0 takes one per core.
    explicit RenderSession(int threads = 0);
    ~RenderSession();
    RenderSession(const RenderSession&) = delete;
    RenderSession& operator=(const RenderSession&) = delete;

    /// Throws std::invalid_argument if the scene is null or refers to what does not exist, if the image has
    /// no pixels or more than kMaxImagePixels, if the region is empty or not within the image, or if a
    /// setting is out of range.
    void submit(RenderRequest request);
    void pause();  ///< drops the tiles in flight; no effect unless compiling or rendering
    void resume();
    /// Drops the tiles in flight; the film stays, and a later submit() of the same request continues it.
    void cancel();
    /// Like cancel(), but completes the tiles in flight that end within half a second.
    void finishTiles();

    RenderStatus status() const;
    /// Calls `take` for each tile that changed since it was last delivered, until `budgetSeconds` have
    /// passed; at least for one. Returns the number of tiles delivered.
    int collect(const std::function<void(const TileView&)>& take, double budgetSeconds = 1e9);
    /// Blocks until the state is neither Compiling nor Rendering, or `seconds` have passed. Returns the
    /// state.
    RenderState wait(double seconds = 1e9);

    /// What has been traced last or is being traced; nothing until the first request is compiled.
    std::optional<TracedPicture> picture() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rayscope
