#include "viewer/jobs/render_control.h"

#include <algorithm>
#include <thread>

#include "render/film.h"
#include "sampling/sample_stream.h"

namespace rayscope::viewer {

namespace {

/// A preview has as many pixels as are traced in this time, compilation included.
constexpr double kPreviewSeconds = 0.05, kLeastPreviewSeconds = 0.015;
/// A picture that nothing of the view precedes is replaced by a coarser one if it takes longer than this.
constexpr double kLateSeconds = 0.04;
/// A compilation that takes longer than this is interrupted by a newer request.
constexpr double kMaxCompileSeconds = 0.4;
/// Samples per second that are assumed of a scene that was not traced yet.
constexpr double kUnknownSpeed = 3e5;

int threadsFor(int wanted) {
    if (wanted > 0) return wanted;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

bool isSameImage(const RenderRequest& a, const RenderRequest& b) {
    return isSameFrame(a, b) && a.settings.spp == b.settings.spp;
}

RenderRequest fullRequest(const RenderControl::ViewRequest& viewRequest) {
    RenderRequest request = requestOf(viewRequest.state, viewRequest.width, viewRequest.height);
    if (viewRequest.stopCriteria.byError && !sampling::dependsOnSampleCount(request.settings.sampler))
        request.settings.spp = RenderControl::kMaxSamples;
    return request;
}

/// Whether samples of one are samples of the other.
bool hasSameSamples(const RenderRequest& a, const RenderRequest& b) {
    return isSameFrame(a, b) &&
           (a.settings.spp == b.settings.spp || !sampling::dependsOnSampleCount(a.settings.sampler));
}

}  // namespace

RenderControl::RenderControl(int threads)
    : threads_(threadsFor(threads)),
      yields_(threads <= 0 && threads_ > 1),
      session_(threads_),
      pixelsPerSecond_(kUnknownSpeed) {}

void RenderControl::yieldCore(bool moving) {
    using oneapi::tbb::global_control;
    if (!moving || !yields_)
        yielded_.reset();
    else if (!yielded_)
        yielded_.emplace(global_control::max_allowed_parallelism, static_cast<std::size_t>(threads_ - 1));
}

/// The smallest divisor of the size with which a picture is traced in time.
int RenderControl::affordableDivisor(const ViewRequest& viewRequest) const {
    const double pixels = static_cast<double>(viewRequest.width) * viewRequest.height;
    const double seconds = std::max(kLeastPreviewSeconds, kPreviewSeconds - status_.compileSeconds);
    int divisor = 1;
    while (divisor < kCoarsestDivisor && pixels / (divisor * divisor) > pixelsPerSecond_ * seconds)
        divisor *= 2;
    return divisor;
}

int RenderControl::nextDivisor(const ViewRequest& viewRequest, const RenderRequest& full) const {
    const int affordable = affordableDivisor(viewRequest);
    const std::optional<int> shown = shownDivisor(full);
    if (!shown) return affordable;
    if (viewRequest.moving) return std::min(affordable, *shown);
    // A preview that turned out to be coarser than necessary is followed by a finer one.
    const bool refining = submitted_ && !coarse_ && isSameFrame(*submitted_, full);
    return affordable < *shown && !refining ? affordable : 1;
}

/// The divisor of the whole picture of the view; nothing if there is none.
std::optional<int> RenderControl::shownDivisor(const RenderRequest& full) const {
    return whole_ ? previewDivisor(whole_->request(), full) : std::nullopt;
}

/// Whether the first picture of the view takes longer than expected.
bool RenderControl::isLate(const RenderRequest& full) const {
    return status_.state == RenderState::Rendering && status_.samples == 0 && submitted_ &&
           isSameView(*submitted_, full) && !shownDivisor(full) && status_.elapsedSeconds > kLateSeconds &&
           submitted_->width > full.width / kCoarsestDivisor;
}

/// A preview is not interrupted before it is whole: it would never be shown.
bool RenderControl::mayInterrupt() const {
    if (status_.state == RenderState::Compiling)
        return std::chrono::duration<double>(Clock::now() - submittedAt_).count() > kMaxCompileSeconds;
    return status_.state != RenderState::Rendering || status_.samples > 0;
}

void RenderControl::submit(RenderRequest request, bool coarse) {
    coarse_ = coarse;
    if (submitted_ && isSameImage(*submitted_, request)) return;
    if (submitted_ && submitted_->scene->path != request.scene->path)
        pixelsPerSecond_ = std::min(pixelsPerSecond_, kUnknownSpeed);
    submitted_ = request;
    stopReason_.reset();
    resting_ = false;
    submittedAt_ = Clock::now();
    session_.submit(std::move(request));
    status_ = session_.status();
}

void RenderControl::takeWhole() {
    const std::optional<TracedPicture> picture = session_.picture();
    if (picture && picture->film()->completeSamples() > 0) whole_ = picture;
}

void RenderControl::measureSpeed() {
    const bool measurable = status_.state == RenderState::Rendering || status_.state == RenderState::Done;
    if (!measurable || !submitted_ || status_.progress <= 0.0 || status_.elapsedSeconds < 1e-3) return;
    const double traced = status_.progress * status_.targetSamples * submitted_->width * submitted_->height;
    pixelsPerSecond_ = std::max(1e3, traced / status_.elapsedSeconds);
}

/// While the rasterised view is shown, one sample of every pixel is enough.
void RenderControl::updateRasterised(const ViewRequest& viewRequest) {
    if (viewRequest.moving) return;
    const RenderRequest full = fullRequest(viewRequest);
    if (coarse_ || !submitted_ || !hasSameSamples(*submitted_, full))
        return submit(previewOf(full, 1), false);
    if (status_.state != RenderState::Rendering || status_.samples == 0 || resting_) return;
    session_.finishTiles();
    resting_ = true;
}

/// Resumes a render that the rasterised view or an earlier stop criterion ended.
void RenderControl::resume(const ViewRequest& viewRequest, const RenderRequest& full) {
    const bool isStopped = stopReason_ && stopCriteria_ != viewRequest.stopCriteria;
    if ((!resting_ && !isStopped) || !submitted_ || !isSameImage(*submitted_, full)) return;
    stopReason_.reset();
    resting_ = false;
    session_.submit(full);
    status_ = session_.status();
}

void RenderControl::update(const ViewRequest& viewRequest) {
    yieldCore(viewRequest.moving);
    status_ = session_.status();
    takeWhole();
    measureSpeed();
    updateErrorEstimate(viewRequest);
    if (!viewRequest.traced) return updateRasterised(viewRequest);
    RenderRequest full = fullRequest(viewRequest);
    resume(viewRequest, full);
    stopCriteria_ = viewRequest.stopCriteria;
    applyStopCriteria(viewRequest);
    if (isLate(full)) {
        constexpr double kSlower = 8.0;
        const double tried = submitted_->width * static_cast<double>(submitted_->height) / kLateSeconds;
        pixelsPerSecond_ = std::min(pixelsPerSecond_, tried) / kSlower;
    } else if (coarse_ && !mayInterrupt()) {
        return;
    }
    const bool refining = submitted_ && !coarse_ && isSameFrame(*submitted_, full);
    if (viewRequest.moving && refining) return;
    const int divisor = nextDivisor(viewRequest, full);
    const bool coarse = divisor > 1 || viewRequest.moving;
    submit(coarse ? previewOf(full, divisor) : std::move(full), coarse);
}

/// Estimates the error of the full picture, in the background.
void RenderControl::updateErrorEstimate(const ViewRequest& viewRequest) {
    const std::optional<TracedPicture> picture = session_.picture();
    const std::shared_ptr<const render::Film> film = picture ? picture->film() : nullptr;
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

std::optional<TracedPicture> RenderControl::currentPicture() const {
    if (coarse_ || !submitted_) return std::nullopt;
    std::optional<TracedPicture> picture = session_.picture();
    return picture && hasSameSamples(picture->request(), *submitted_) ? picture : std::nullopt;
}

std::shared_ptr<const trace::World> RenderControl::currentWorld() const {
    const std::optional<TracedPicture> picture = currentPicture();
    return picture ? picture->world() : nullptr;
}

bool RenderControl::busy() const {
    return status_.state == RenderState::Compiling || status_.state == RenderState::Rendering;
}

}  // namespace rayscope::viewer
