#pragma once
// Rendering to the end in one call. RenderSession renders in the background.
#include <rayscope/image.h>
#include <rayscope/render_session.h>
#include <functional>
#include <memory>
#include <stop_token>

namespace rayscope {

struct RenderOptions {
    int threads = 0;         ///< 0: one per core
    double timeLimit = 0.0;  ///< seconds, compilation included; 0: none
    std::stop_token stop;    ///< stops after the tiles in flight that end within half a second
    std::function<void(const RenderStatus&)> progress;  ///< called about 20 times per second and at the end
};

/// An image with the request, the compiled scene and the film of its render.
struct RenderedImage {
    RenderRequest request;
    /// Mean of the samples of each pixel, linear; 0 outside the region and before the first sample.
    RgbImage mean;
    RenderStatus status;
    /// The compiled scene, for probes and AOVs; null if stopped before it was compiled.
    std::shared_ptr<const trace::World> world;
    std::shared_ptr<const render::Film> film;  ///< for AOVs and replays; null like `world`

    /// False if the time limit or a stop ended it early.
    bool isComplete() const { return status.state == RenderState::Done; }
};

/// Renders until all samples are computed, the time limit is reached or a stop is requested, and blocks until
/// then. Throws InputError if the scene cannot be rendered, and OutOfMemory (memory.h).
RenderedImage renderImage(const RenderRequest& request, const RenderOptions& options = {});

/// Compiles the scene of the request for probes, without rendering. Throws InputError.
std::shared_ptr<const trace::World> compileScene(const RenderRequest& request);

/// The mean of each pixel of a film, like RenderedImage::mean.
RgbImage meanOf(const render::Film& film);
/// The number of samples that every pixel of a film has, and that of one pixel of its region.
int samplesOf(const render::Film& film);
int samplesOf(const render::Film& film, int x, int y);

/// The metadata for the image file of a render: program and version, name of the scene without its folder and
/// whether it was edited, camera, settings, seed, samples per pixel.
ImageMetadata metadataOf(const RenderRequest& request, int samples);

/// The same for pixels that were copied from a film: with the smallest and the largest number of samples of a
/// pixel and, if all have the same, the command line that renders the same pixels, as far as there is one.
ImageMetadata metadataOf(const StillPicture& picture);

}  // namespace rayscope
