#include "viewer/jobs/render_control.h"

#include <algorithm>
#include <thread>

namespace rayscope::viewer {

namespace {

/// A coarse picture should be complete this soon, so that the scene follows the hand.
constexpr double kPreviewSeconds = 0.07;
/// A picture that takes longer than this is given up for a newer one, even if it has holes.
constexpr double kMostPatience = 0.4;

int threadsFor(int wanted) {
    if (wanted > 0) return wanted;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
}

/// Whether both show the same, whatever their size and number of samples.
bool sameView(const RenderRequest& a, const RenderRequest& b) {
    Settings settings = a.settings;
    settings.spp = b.settings.spp;
    return a.scene == b.scene && a.camera == b.camera &&
           changed(settings, b.settings) <= Invalidates::Display;
}

bool sameImage(const RenderRequest& a, const RenderRequest& b) {
    return sameView(a, b) && a.width == b.width && a.height == b.height && a.settings.spp == b.settings.spp;
}

/// As many samples as any target could need.
constexpr int kMostSamples = 1 << 16;

RenderRequest requestFor(const RenderControl::Wish& wish, int divisor) {
    RenderRequest request;
    request.scene = wish.state.scene;
    request.settings = wish.state.settings;
    request.camera = wish.state.camera;
    request.width = std::max(1, wish.width / divisor);
    request.height = std::max(1, wish.height / divisor);
    // A jittered pattern must know how many samples follow.
    if (wish.goal.byError && request.settings.sampler != SamplePattern::Jittered)
        request.settings.spp = kMostSamples;
    if (divisor > 1 || wish.moving || !wish.traced) request.settings.spp = 1;
    return request;
}

}  // namespace

RenderControl::RenderControl(int threads) : threads_(threadsFor(threads)), session_(threads_) {}

int RenderControl::previewDivisor(const Wish& wish) const {
    const double pixels = static_cast<double>(wish.width) * wish.height;
    int divisor = 1;
    while (divisor < 8 && pixels / (divisor * divisor) > pixelsPerSecond_ * kPreviewSeconds) divisor *= 2;
    return divisor;
}

/// While the camera moves, a new picture waits until the last one has a sample in every pixel: otherwise the
/// tiles that come last would never be seen.
bool RenderControl::mayInterrupt() const {
    const bool complete = status_.samples > 0 || status_.state == RenderState::Done;
    const bool failed = status_.state == RenderState::Failed || status_.state == RenderState::Idle;
    return complete || failed ||
           std::chrono::duration<double>(Clock::now() - submittedAt_).count() > kMostPatience;
}

void RenderControl::submit(RenderRequest request, bool coarse) {
    if (submitted_ && sameImage(*submitted_, request)) return;
    submitted_ = request;
    stopped_.reset();
    coarse_ = coarse;
    submittedAt_ = Clock::now();
    session_.submit(std::move(request));
    status_ = session_.status();
}

void RenderControl::update(const Wish& wish) {
    status_ = session_.status();
    const bool measurable = status_.state == RenderState::Rendering || status_.state == RenderState::Done;
    if (measurable && status_.elapsedSeconds > 0.01) {
        const double samples = status_.progress * status_.targetSamples;
        const double traced = samples * submitted_->width * submitted_->height;
        pixelsPerSecond_ = std::max(1e3, traced / status_.elapsedSeconds);
    }
    watchError(wish);
    if (!wish.traced) {
        if (!wish.moving) submit(requestFor(wish, 1), false);
        return;
    }
    RenderRequest full = requestFor(wish, 1);
    // What a former goal ended goes on.
    if (stopped_ && goal_ != wish.goal && submitted_ && sameImage(*submitted_, full)) {
        stopped_.reset();
        session_.submit(full);
    }
    goal_ = wish.goal;
    stopAtGoal(wish);
    const bool sameAsBefore = submitted_ && sameView(*submitted_, full);
    const int divisor = previewDivisor(wish);
    // What was not seen yet is shown coarsely first, if the whole picture would take too long.
    const bool preview = wish.moving || (!sameAsBefore && divisor > 1);
    if (coarse_ && !mayInterrupt()) return;
    submit(preview ? requestFor(wish, divisor) : std::move(full), preview);
}

/// Keeps an eye on the film of the full picture, beside the window.
void RenderControl::watchError(const Wish& wish) {
    const auto film = session_.film();
    const bool isOtherTarget = goal_.error != wish.goal.error || goal_.confidence != wish.goal.confidence;
    if (film != watchedFilm_ || isOtherTarget || !watch_) {
        watchedFilm_ = film;
        watch_ = std::make_shared<const measure::ErrorWatch>(
            ErrorTarget{.error = static_cast<double>(wish.goal.error),
                        .confidence = static_cast<double>(wish.goal.confidence)},
            wish.state.settings.sampler);
    }
    if (looking_.valid()) {
        if (looking_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        auto looked = looking_.get();
        if (lookedFrom_ == watch_) watch_ = std::move(looked);
    }
    if (!film || coarse_ || !wish.traced || !watch_->wantsLook(film->completeSamples())) return;
    lookedFrom_ = watch_;
    looking_ = std::async(std::launch::async,
                          [before = watch_, film]() -> std::shared_ptr<const measure::ErrorWatch> {
                              auto next = std::make_shared<measure::ErrorWatch>(*before);
                              next->look(measure::ErrorWatch::take(*film));
                              return next;
                          });
}

void RenderControl::stopAtGoal(const Wish& wish) {
    if (status_.state != RenderState::Rendering || coarse_ || stopped_) return;
    if (wish.goal.byError && watch_->reached())
        stopped_ = StopReason::Reached;
    else if (wish.goal.byTime && status_.elapsedSeconds >= static_cast<double>(wish.goal.seconds))
        stopped_ = StopReason::TimeLimit;
    if (stopped_) session_.finishTiles();
}

std::optional<ErrorForecast> RenderControl::forecast() const {
    if (!watch_ || !watch_->any() || coarse_ || !watchedFilm_) return std::nullopt;
    const double samples =
        std::max<double>(watchedFilm_->completeSamples(), status_.progress * status_.targetSamples);
    return watch_->forecast(samples, status_.elapsedSeconds,
                            goal_.byTime ? static_cast<double>(goal_.seconds) : 0.0);
}

void RenderControl::togglePause() {
    if (paused())
        session_.resume();
    else
        session_.pause();
}

double RenderControl::raysPerSecond() const {
    return status_.elapsedSeconds > 0.0 ? static_cast<double>(status_.rays) / status_.elapsedSeconds : 0.0;
}

std::shared_ptr<const trace::World> RenderControl::settledWorld() const {
    const RenderState state = session_.status().state;
    const bool compiled = state == RenderState::Rendering || state == RenderState::Done ||
                          (state == RenderState::Idle && stopped_);
    return compiled && !coarse_ ? session_.world() : nullptr;
}

bool RenderControl::busy() const {
    return status_.state == RenderState::Compiling || status_.state == RenderState::Rendering;
}

}  // namespace rayscope::viewer
