#include <rayscope/diagnostics.h>
#include <rayscope/memory.h>
#include <rayscope/render_image.h>
#include <chrono>

#include "render/film.h"
#include "render/image_metadata.h"
#include "render/probe_command.h"
#include "trace/compile.h"

namespace rayscope {

namespace {

/// Blocks until the session has ended in one of the ways of renderImage(). Returns its last status.
RenderStatus waitFor(RenderSession& session, const RenderOptions& options) {
    using Clock = std::chrono::steady_clock;
    constexpr double kProgressInterval = 0.05;  // seconds
    const Clock::time_point start = Clock::now();
    for (;;) {
        const RenderState state = session.wait(kProgressInterval);
        RenderStatus status = session.status();
        if (state == RenderState::Failed && status.outOfMemory) throw OutOfMemory(status.message);
        if (state == RenderState::Failed) throw InputError(status.message);
        if (state == RenderState::Done) return status;
        const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
        if (options.stop.stop_requested() || (options.timeLimit > 0.0 && elapsed >= options.timeLimit)) {
            session.finishTiles();
            session.wait();
            return session.status();
        }
        if (options.progress) options.progress(status);
    }
}

}  // namespace

RenderedImage renderImage(const RenderRequest& request, const RenderOptions& options) {
    RenderedImage image;
    image.request = request;
    RenderSession session(options.threads);
    RenderRequest submitted = request;
    // With a limit every pixel should have samples early; without one, larger passes cost less.
    submitted.progressive = options.timeLimit > 0.0;
    session.submit(std::move(submitted));
    image.status = waitFor(session, options);
    if (options.progress) options.progress(image.status);
    if (const std::optional<TracedPicture> picture = session.picture()) {
        image.world = picture->world();
        image.film = picture->film();
    }
    image.mean = image.film ? image.film->mean() : RgbImage(request.width, request.height);
    return image;
}

std::shared_ptr<const trace::World> compileScene(const RenderRequest& request) {
    return trace::compile({request.scene, request.settings, request.camera, request.width, request.height});
}

RgbImage meanOf(const render::Film& film) { return film.mean(); }

int samplesOf(const render::Film& film) { return film.completeSamples(); }

int samplesOf(const render::Film& film, int x, int y) {
    int samples = 0;
    film.sums(x, y, samples);
    return samples;
}

ImageMetadata metadataOf(const RenderRequest& request, int samples) {
    return render::imageMetadata(request, samples);
}

ImageMetadata metadataOf(const StillPicture& picture) {
    const int least = picture.leastSamples(), most = picture.mostSamples();
    ImageMetadata metadata = metadataOf(picture.request(), least);
    if (most != least) {
        metadata["samples.most"] = std::to_string(most);
    } else if (const auto command = render::renderCommand(picture.request(), least)) {
        metadata["command"] = *command;
    }
    return metadata;
}

}  // namespace rayscope
