#include "viewer/jobs/render_control.h"

#include <algorithm>
#include <thread>

#include "sampling/sample_stream.h"

namespace rayscope::viewer {

namespace {

/// A preview has as many pixels as are traced in this time.
constexpr double kPreviewSeconds = 0.07;
/// A preview that takes longer than this is interrupted by a newer one, even if it is incomplete.
constexpr double kMaxPreviewSeconds = 0.4;

int threadsFor(int wanted) {
    if (wanted > 0) return wanted;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Whether both show the same view, whatever their size and number of samples.
bool sameView(const RenderRequest& a, const RenderRequest& b) {
    Settings settings = a.settings;
    settings.spp = b.settings.spp;
    return a.scene == b.scene && a.camera == b.camera &&
           changed(settings, b.settings) <= Invalidates::Display;
}

bool sameImage(const RenderRequest& a, const RenderRequest& b) {
    return sameView(a, b) && a.width == b.width && a.height == b.height && a.settings.spp == b.settings.spp;
}

/// The number of samples of a picture that stops at an error target.
constexpr int kMaxSamples = 1 << 16;

RenderRequest requestFor(const RenderControl::ViewRequest& viewRequest, int divisor) {
    RenderRequest request = requestOf(viewRequest.state, std::max(1, viewRequest.width / divisor),
                                      std::max(1, viewRequest.height / divisor));
    if (viewRequest.stopCriteria.byError && !sampling::dependsOnSampleCount(request.settings.sampler))
        request.settings.spp = kMaxSamples;
    if (divisor > 1 || viewRequest.moving || !viewRequest.traced) request.settings.spp = 1;
    return request;
}

}  // namespace

RenderControl::RenderControl(int threads)
    : threads_(threadsFor(threads)), yields_(threads <= 0 && threads_ > 1), session_(threads_) {}

void RenderControl::yieldCore(bool moving) {
    using oneapi::tbb::global_control;
    if (!moving || !yields_)
        yielded_.reset();
    else if (!yielded_)
        yielded_.emplace(global_control::max_allowed_parallelism, static_cast<std::size_t>(threads_ - 1));
}

int RenderControl::previewDivisor(const ViewRequest& viewRequest) const {
    const double pixels = static_cast<double>(viewRequest.width) * viewRequest.height;
    int divisor = 1;
    while (divisor < 8 && pixels / (divisor * divisor) > pixelsPerSecond_ * kPreviewSeconds) divisor *= 2;
    return divisor;
}

/// While the camera moves, a preview is only interrupted once every pixel has a sample: otherwise the last
/// tiles would never be shown.
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
    yieldCore(viewRequest.moving);
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
    // Resume a render that an earlier stop criterion ended.
    if (stopReason_ && stopCriteria_ != viewRequest.stopCriteria && submitted_ &&
        sameImage(*submitted_, full)) {
        stopReason_.reset();
        session_.submit(full);
    }
    stopCriteria_ = viewRequest.stopCriteria;
    applyStopCriteria(viewRequest);
    const bool sameAsBefore = submitted_ && sameView(*submitted_, full);
    const int divisor = previewDivisor(viewRequest);
    // A new view starts with a preview if the whole picture would take too long.
    const bool preview = viewRequest.moving || (!sameAsBefore && divisor > 1);
    if (coarse_ && !mayInterrupt()) return;
    submit(preview ? requestFor(viewRequest, divisor) : std::move(full), preview);
}

/// Estimates the error of the full picture, in the background.
void RenderControl::updateErrorEstimate(const ViewRequest& viewRequest) {
    const auto film = session_.film();
    const bool isOtherTarget = stopCriteria_.error != viewRequest.stopCriteria.error ||
                               stopCriteria_.confidence != viewRequest.stopCriteria.confidence;
    if (film != estimatedFilm_ || isOtherTarget || !monitor_) {
        estimatedFilm_ = film;
        estimation_.discard();
        monitor_ = std::make_shared<const measure::ErrorMonitor>(
            ErrorTarget{.error = static_cast<double>(viewRequest.stopCriteria.error),
                        .confidence = static_cast<double>(viewRequest.stopCriteria.confidence)},
            viewRequest.state.settings.sampler);
    }
    if (auto updated = estimation_.poll()) monitor_ = std::move(*updated);
    if (estimation_.busy() || !film || coarse_ || !viewRequest.traced ||
        !monitor_->isEstimateDue(film->completeSamples()))
        return;
    estimation_.start([monitor = monitor_, film](const std::stop_token&, JobProgress&) -> ErrorMonitorPtr {
        auto next = std::make_shared<measure::ErrorMonitor>(*monitor);
        next->update(measure::ErrorMonitor::snapshotOf(*film));
        return next;
    });
}

void RenderControl::applyStopCriteria(const ViewRequest& viewRequest) {
    if (status_.state != RenderState::Rendering || coarse_ || stopReason_) return;
    if (viewRequest.stopCriteria.byError && monitor_->reached())
        stopReason_ = StopReason::Reached;
    else if (viewRequest.stopCriteria.byTime &&
             status_.elapsedSeconds >= static_cast<double>(viewRequest.stopCriteria.seconds))
        stopReason_ = StopReason::TimeLimit;
    if (stopReason_) session_.finishTiles();
}

std::optional<ErrorForecast> RenderControl::forecast() const {
    if (!monitor_ || !monitor_->hasEstimate() || coarse_ || !estimatedFilm_) return std::nullopt;
    const double samples =
        std::max<double>(estimatedFilm_->completeSamples(), status_.progress * status_.targetSamples);
    return monitor_->forecast(samples, status_.elapsedSeconds,
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
