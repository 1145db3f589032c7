#include "viewer/jobs/render_control.h"

#include <algorithm>
#include <thread>

#include "sampling/sample_stream.h"

namespace rayscope::viewer {

namespace {

/// A coarse picture should be complete this soon, so that the scene follows the hand.
constexpr double kPreviewSeconds = 0.07;
/// A picture that takes longer than this is given up for a newer one, even if it has holes.
constexpr double kMaxPreviewSeconds = 0.4;

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
constexpr int kMaxSamples = 1 << 16;

RenderRequest requestFor(const RenderControl::ViewRequest& viewRequest, int divisor) {
    RenderRequest request;
    request.scene = viewRequest.state.scene;
    request.settings = viewRequest.state.settings;
    request.camera = viewRequest.state.camera;
    request.width = std::max(1, viewRequest.width / divisor);
    request.height = std::max(1, viewRequest.height / divisor);
    if (viewRequest.stopCriteria.byError && !sampling::dependsOnSampleCount(request.settings.sampler))
        request.settings.spp = kMaxSamples;
    if (divisor > 1 || viewRequest.moving || !viewRequest.traced) request.settings.spp = 1;
    return request;
}

}  // namespace

RenderControl::RenderControl(int threads) : threads_(threadsFor(threads)), session_(threads_) {}

int RenderControl::previewDivisor(const ViewRequest& viewRequest) const {
    const double pixels = static_cast<double>(viewRequest.width) * viewRequest.height;
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
           std::chrono::duration<double>(Clock::now() - submittedAt_).count() > kMaxPreviewSeconds;
}

void RenderControl::submit(RenderRequest request, bool coarse) {
    if (submitted_ && sameImage(*submitted_, request)) return;
    submitted_ = request;
    stopReason_.reset();
    coarse_ = coarse;
    submittedAt_ = Clock::now();
    session_.submit(std::move(request));
    status_ = session_.status();
}

void RenderControl::update(const ViewRequest& viewRequest) {
    status_ = session_.status();
    const bool measurable = status_.state == RenderState::Rendering || status_.state == RenderState::Done;
    if (measurable && status_.elapsedSeconds > 0.01) {
        const double samples = status_.progress * status_.targetSamples;
        const double traced = samples * submitted_->width * submitted_->height;
        pixelsPerSecond_ = std::max(1e3, traced / status_.elapsedSeconds);
    }
    updateErrorEstimate(viewRequest);
    if (!viewRequest.traced) {
        if (!viewRequest.moving) submit(requestFor(viewRequest, 1), false);
        return;
    }
    RenderRequest full = requestFor(viewRequest, 1);
    // What a former stopCriteria ended goes on.
    if (stopReason_ && stopCriteria_ != viewRequest.stopCriteria && submitted_ &&
        sameImage(*submitted_, full)) {
        stopReason_.reset();
        session_.submit(full);
    }
    stopCriteria_ = viewRequest.stopCriteria;
    applyStopCriteria(viewRequest);
    const bool sameAsBefore = submitted_ && sameView(*submitted_, full);
    const int divisor = previewDivisor(viewRequest);
    // What was not seen yet is shown coarsely first, if the whole picture would take too long.
    const bool preview = viewRequest.moving || (!sameAsBefore && divisor > 1);
    if (coarse_ && !mayInterrupt()) return;
    submit(preview ? requestFor(viewRequest, divisor) : std::move(full), preview);
}

/// Keeps an eye on the film of the full picture, beside the window.
void RenderControl::updateErrorEstimate(const ViewRequest& viewRequest) {
    const auto film = session_.film();
    const bool isOtherTarget = stopCriteria_.error != viewRequest.stopCriteria.error ||
                               stopCriteria_.confidence != viewRequest.stopCriteria.confidence;
    if (film != estimatedFilm_ || isOtherTarget || !watch_) {
        estimatedFilm_ = film;
        watch_ = std::make_shared<const measure::ErrorMonitor>(
            ErrorTarget{.error = static_cast<double>(viewRequest.stopCriteria.error),
                        .confidence = static_cast<double>(viewRequest.stopCriteria.confidence)},
            viewRequest.state.settings.sampler);
    }
    if (estimating_.valid()) {
        if (estimating_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        auto looked = estimating_.get();
        if (estimatedFrom_ == watch_) watch_ = std::move(looked);
    }
    if (!film || coarse_ || !viewRequest.traced || !watch_->isEstimateDue(film->completeSamples())) return;
    estimatedFrom_ = watch_;
    estimating_ = std::async(std::launch::async,
                             [before = watch_, film]() -> std::shared_ptr<const measure::ErrorMonitor> {
                                 auto next = std::make_shared<measure::ErrorMonitor>(*before);
                                 next->look(measure::ErrorMonitor::take(*film));
                                 return next;
                             });
}

void RenderControl::applyStopCriteria(const ViewRequest& viewRequest) {
    if (status_.state != RenderState::Rendering || coarse_ || stopReason_) return;
    if (viewRequest.stopCriteria.byError && watch_->reached())
        stopReason_ = StopReason::Reached;
    else if (viewRequest.stopCriteria.byTime &&
             status_.elapsedSeconds >= static_cast<double>(viewRequest.stopCriteria.seconds))
        stopReason_ = StopReason::TimeLimit;
    if (stopReason_) session_.finishTiles();
}

std::optional<ErrorForecast> RenderControl::forecast() const {
    if (!watch_ || !watch_->any() || coarse_ || !estimatedFilm_) return std::nullopt;
    const double samples =
        std::max<double>(estimatedFilm_->completeSamples(), status_.progress * status_.targetSamples);
    return watch_->forecast(samples, status_.elapsedSeconds,
                            stopCriteria_.byTime ? static_cast<double>(stopCriteria_.seconds) : 0.0);
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

std::shared_ptr<const trace::World> RenderControl::currentWorld() const {
    const RenderState state = session_.status().state;
    const bool compiled = state == RenderState::Rendering || state == RenderState::Done ||
                          (state == RenderState::Idle && stopReason_);
    return compiled && !coarse_ ? session_.world() : nullptr;
}

bool RenderControl::busy() const {
    return status_.state == RenderState::Compiling || status_.state == RenderState::Rendering;
}

}  // namespace rayscope::viewer
