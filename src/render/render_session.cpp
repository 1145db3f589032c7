#include <rayscope/render_session.h>

#include <algorithm>

#include "base/check_argument.h"
#include "render/check_request.h"
#include "render/session_state.h"

namespace rayscope {

RenderSession::RenderSession(int threads) : state_(std::make_unique<State>(threads)) {
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
    render::checkRequest(request);
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
    // A request that has not been started has nothing to stop.
    if (state_->pending) {
        state_->status.state = RenderState::Paused;
        state_->changedState.notify_all();
    }
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
    std::shared_ptr<const render::Film> film;
    RenderStatus status;
    double doneAtStart = 0.0, runningSeconds = 0.0;
    {
        const std::scoped_lock guard(state_->lock);
        status = state_->status;
        film = state_->film;
        status.rays = state_->counters.rays;
        status.nonFiniteSamples = state_->counters.nonFiniteSamples;
        doneAtStart = state_->doneAtStart;
        if (status.state == RenderState::Rendering) runningSeconds = render::secondsSince(state_->started);
    }
    if (!film || status.targetSamples == 0) return status;
    status.samples = std::min(film->completeSamples(), status.targetSamples);
    status.progress = film->doneFraction(status.targetSamples);
    status.elapsedSeconds += runningSeconds;
    if (status.state == RenderState::Rendering && status.progress > doneAtStart)
        status.remainingSeconds = runningSeconds * (1.0 - status.progress) / (status.progress - doneAtStart);
    return status;
}

int RenderSession::collect(const std::function<void(const TileView&)>& take, double budgetSeconds) {
    base::checkArgument(static_cast<bool>(take), "take is empty");
    const render::SessionClock::time_point start = render::SessionClock::now();
    State& s = *state_;
    const std::optional<TracedPicture> picture = this->picture();
    if (!picture) return 0;
    const std::shared_ptr<const render::Film>& film = picture->film();
    if (film != s.collectedFilm) {
        s.collectedFilm = film;
        s.collectedVersions.assign(static_cast<std::size_t>(film->tileCount()), 0);
        s.nextTile = 0;
    }
    int delivered = 0;
    render::Film::TileCopy copy;
    std::vector<Rgb> mean;
    // Continue where the last call ran out of time, so that every tile is delivered eventually.
    for (int visited = 0; visited < film->tileCount();
         ++visited, s.nextTile = (s.nextTile + 1) % film->tileCount()) {
        if (delivered > 0 && render::secondsSince(start) > budgetSeconds) break;
        const int tile = s.nextTile;
        std::uint32_t& collected = s.collectedVersions[static_cast<std::size_t>(tile)];
        if (film->version(tile) == collected) continue;
        film->read(tile, copy);
        collected = copy.version;
        mean.clear();
        for (const render::PixelSums& pixel : copy.pixels)
            mean.push_back(Rgb(pixel.radiance / static_cast<double>(copy.samples)));
        const PixelBounds bounds = film->tileBounds(tile);
        take({*picture, bounds.x0, bounds.y0, bounds.x1 - bounds.x0, bounds.y1 - bounds.y0, film->width(),
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
    state_->changedState.wait_for(guard, std::chrono::duration_cast<render::SessionClock::duration>(limit),
                                  settled);
    return state_->status.state;
}

std::optional<TracedPicture> RenderSession::picture() const {
    const std::scoped_lock guard(state_->lock);
    return state_->picture;
}

StillPicture TracedPicture::still() const {
    StillPicture still;
    still.request_ = request_;
    still.mean_ = film_->mean(still.leastSamples_, still.mostSamples_);
    // A later request for more samples may have continued the film.
    still.request_.settings.spp = std::max(still.request_.settings.spp, still.mostSamples_);
    return still;
}

void StillPicture::setDisplay(const Settings& settings) {
    request_.settings = withDisplayOf(request_.settings, settings);
}

}  // namespace rayscope
