#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

#include <rayscope/render_session.h>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "render/film.h"
#include "render/pass_plan.h"
#include "render/render_pass.h"
#include "trace/compile.h"

namespace rayscope {

namespace {

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

PixelBounds regionOf(const RenderRequest& request) {
    const PixelBounds whole{0, request.width, 0, request.height};
    return request.region.value_or(whole);
}

/// Whether the samples of a film made for `before` are also the first samples of `after`.
bool continues(const RenderRequest& before, const RenderRequest& after) {
    Settings sameCount = before.settings;
    // Only a jittered pattern depends on how many samples will follow.
    if (after.settings.sampler != SamplePattern::Jittered) sameCount.spp = after.settings.spp;
    return before.scene == after.scene && before.camera == after.camera && before.width == after.width &&
           before.height == after.height && regionOf(before) == regionOf(after) &&
           before.seed == after.seed && changed(sameCount, after.settings) <= Invalidates::Display;
}

double doneFraction(const Film& film, int targetSamples) {
    double sum = 0.0;
    for (int tile = 0; tile < film.tileCount(); ++tile) sum += std::min(film.samples(tile), targetSamples);
    return film.tileCount() == 0 ? 1.0 : sum / (static_cast<double>(film.tileCount()) * targetSamples);
}

int threadCount(int wanted) { return wanted > 0 ? wanted : oneapi::tbb::info::default_concurrency(); }

}  // namespace

/// One thread runs requests, one at a time. Everything under `lock` is shared with the caller; the caller
/// never waits for more than a copy. `stop` interrupts whatever runs at present.
struct RenderSession::State {
    explicit State(int threads)
        : parallelism(oneapi::tbb::global_control::max_allowed_parallelism,
                      static_cast<std::size_t>(std::max(threads, oneapi::tbb::info::default_concurrency()))),
          arena(threads) {}

    void run();
    void serve(const RenderRequest& request, std::uint64_t epoch, const PassControl& control);
    void prepareFilm(const RenderRequest& request);
    bool renderPasses(const RenderRequest& request, const PassControl& control);

    oneapi::tbb::global_control parallelism;
    oneapi::tbb::task_arena arena;

    mutable std::mutex lock;
    std::condition_variable changedState;
    std::optional<RenderRequest> pending;
    bool paused = false, quitting = false;
    std::uint64_t epoch = 0;
    std::stop_source stop, drain;
    RenderStatus status;
    std::shared_ptr<const World> world;
    std::shared_ptr<Film> film;
    std::optional<RenderRequest> filmRequest;  ///< what the film was made for
    RenderCounters counters;
    Clock::time_point started{};
    double doneAtStart = 0.0;

    // Only collect() uses these.
    std::shared_ptr<Film> collectedFilm;
    std::vector<std::uint32_t> collectedVersions;
    int nextTile = 0;

    std::jthread thread;  ///< last, so that everything else outlives it
};

void RenderSession::State::run() {
    for (;;) {
        RenderRequest request;
        std::uint64_t number = 0;
        PassControl control;
        {
            std::unique_lock guard(lock);
            changedState.wait(guard, [&] { return quitting || (pending && !paused); });
            if (quitting) return;
            request = std::move(*pending);
            pending.reset();
            number = epoch;
            stop = std::stop_source{};
            drain = std::stop_source{};
            control = {stop.get_token(), drain.get_token()};
            status.state = RenderState::Compiling;
            status.message.clear();
        }
        serve(request, number, control);
    }
}

void RenderSession::State::serve(const RenderRequest& request, std::uint64_t number,
                                 const PassControl& control) {
    RenderState outcome = RenderState::Idle;
    std::string message;
    try {
        const Clock::time_point start = Clock::now();
        std::shared_ptr<const World> compiled;
        arena.execute([&] {
            compiled =
                compile({request.scene, request.settings, request.camera, request.width, request.height},
                        world.get(), control.stop);
        });
        {
            const std::scoped_lock guard(lock);
            world = compiled;
            status.compileSeconds = secondsSince(start);
            status.buildSeconds = compiled->buildSeconds;
        }
        prepareFilm(request);
        if (renderPasses(request, control)) outcome = RenderState::Done;
    } catch (const Stopped&) {
        // The next request says what to do.
    } catch (const std::exception& error) {
        outcome = RenderState::Failed;
        message = error.what();
    }
    const std::scoped_lock guard(lock);
    // A pause keeps the request for later, unless a newer one is there already.
    if (outcome == RenderState::Idle && paused && !pending && number == epoch && !quitting) {
        pending = request;
        outcome = RenderState::Paused;
    }
    status.state = pending && !paused ? RenderState::Compiling : outcome;
    status.message = message;
    changedState.notify_all();
}

void RenderSession::State::prepareFilm(const RenderRequest& request) {
    const std::scoped_lock guard(lock);
    if (!film || !filmRequest || !continues(*filmRequest, request)) {
        film = std::make_shared<Film>(request.width, request.height, regionOf(request));
        counters.rays = 0;
        counters.nonFiniteSamples = 0;
        status.elapsedSeconds = 0.0;
    }
    filmRequest = request;
    status.state = RenderState::Rendering;
    status.targetSamples = request.settings.spp;
    started = Clock::now();
    doneAtStart = doneFraction(*film, request.settings.spp);
}

bool RenderSession::State::renderPasses(const RenderRequest& request, const PassControl& control) {
    const int wanted = request.settings.spp;
    bool complete = true;
    for (int samples = film->completeSamples(); complete && samples < wanted;
         samples = film->completeSamples()) {
        const int target = nextPassTarget(samples, wanted, request.progressive);
        arena.execute([&] { complete = renderPass(*world, request.seed, *film, target, control, counters); });
    }
    const std::scoped_lock guard(lock);
    status.elapsedSeconds += secondsSince(started);
    return complete;
}

RenderSession::RenderSession(int threads) : state_(std::make_unique<State>(threadCount(threads))) {
    state_->thread = std::jthread([state = state_.get()] { state->run(); });
}

RenderSession::~RenderSession() {
    {
        const std::scoped_lock guard(state_->lock);
        state_->quitting = true;
        state_->stop.request_stop();
        state_->changedState.notify_all();
    }
    state_->thread.join();
}

void RenderSession::submit(RenderRequest request) {
    const std::scoped_lock guard(state_->lock);
    state_->pending = std::move(request);
    state_->paused = false;
    state_->status.epoch = ++state_->epoch;
    state_->status.state = RenderState::Compiling;
    state_->stop.request_stop();
    state_->changedState.notify_all();
}

void RenderSession::pause() {
    const std::scoped_lock guard(state_->lock);
    const bool busy =
        state_->status.state == RenderState::Compiling || state_->status.state == RenderState::Rendering;
    if (!busy) return;
    state_->paused = true;
    state_->stop.request_stop();
}

void RenderSession::resume() {
    const std::scoped_lock guard(state_->lock);
    state_->paused = false;
    if (state_->status.state == RenderState::Paused) state_->status.state = RenderState::Compiling;
    state_->changedState.notify_all();
}

void RenderSession::cancel() {
    const std::scoped_lock guard(state_->lock);
    state_->pending.reset();
    state_->paused = false;
    state_->stop.request_stop();
    if (state_->status.state == RenderState::Paused) state_->status.state = RenderState::Idle;
    state_->changedState.notify_all();
}

void RenderSession::finishTiles() {
    const std::scoped_lock guard(state_->lock);
    state_->pending.reset();
    state_->paused = false;
    if (state_->status.state == RenderState::Compiling) state_->stop.request_stop();
    state_->drain.request_stop();
    state_->changedState.notify_all();
}

RenderStatus RenderSession::status() const {
    std::shared_ptr<Film> film;
    RenderStatus status;
    double doneAtStart = 0.0, runningSeconds = 0.0;
    {
        const std::scoped_lock guard(state_->lock);
        status = state_->status;
        film = state_->film;
        status.rays = state_->counters.rays;
        status.nonFiniteSamples = state_->counters.nonFiniteSamples;
        doneAtStart = state_->doneAtStart;
        if (status.state == RenderState::Rendering) runningSeconds = secondsSince(state_->started);
    }
    if (!film || status.targetSamples == 0) return status;
    status.samples = std::min(film->completeSamples(), status.targetSamples);
    status.progress = doneFraction(*film, status.targetSamples);
    status.elapsedSeconds += runningSeconds;
    if (status.state == RenderState::Rendering && status.progress > doneAtStart)
        status.remainingSeconds = runningSeconds * (1.0 - status.progress) / (status.progress - doneAtStart);
    return status;
}

int RenderSession::collect(const std::function<void(const TileView&)>& take, double budgetSeconds) {
    const Clock::time_point start = Clock::now();
    State& s = *state_;
    std::shared_ptr<Film> film;
    {
        const std::scoped_lock guard(s.lock);
        film = s.film;
    }
    if (!film) return 0;
    if (film != s.collectedFilm) {
        s.collectedFilm = film;
        s.collectedVersions.assign(static_cast<std::size_t>(film->tileCount()), 0);
        s.nextTile = 0;
    }
    int delivered = 0;
    Film::TileCopy copy;
    std::vector<Rgb> mean;
    // Go on where the last call ran out of time, so that no tile starves.
    for (int visited = 0; visited < film->tileCount();
         ++visited, s.nextTile = (s.nextTile + 1) % film->tileCount()) {
        if (delivered > 0 && secondsSince(start) > budgetSeconds) break;
        const int tile = s.nextTile;
        std::uint32_t& seen = s.collectedVersions[static_cast<std::size_t>(tile)];
        if (film->version(tile) == seen) continue;
        film->read(tile, copy);
        seen = copy.version;
        mean.clear();
        for (const PixelSums& pixel : copy.pixels)
            mean.push_back(Rgb(pixel.radiance / static_cast<double>(copy.samples)));
        const PixelBounds bounds = film->tileBounds(tile);
        take({bounds.x0, bounds.y0, bounds.x1 - bounds.x0, bounds.y1 - bounds.y0, film->width(),
              film->height(), copy.samples, mean});
        ++delivered;
    }
    return delivered;
}

RenderState RenderSession::wait(double seconds) {
    std::unique_lock guard(state_->lock);
    const auto settled = [&] {
        const RenderState state = state_->status.state;
        return state != RenderState::Compiling && state != RenderState::Rendering;
    };
    const auto limit = std::chrono::duration<double>(std::min(seconds, 1e8));
    state_->changedState.wait_for(guard, std::chrono::duration_cast<Clock::duration>(limit), settled);
    return state_->status.state;
}

std::shared_ptr<const World> RenderSession::world() const {
    const std::scoped_lock guard(state_->lock);
    return state_->world;
}

std::shared_ptr<const Film> RenderSession::film() const {
    const std::scoped_lock guard(state_->lock);
    return state_->film;
}

}  // namespace rayscope
