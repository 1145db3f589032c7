#include "measure/trade/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <rayscope/aov.h>
#include <rayscope/compare.h>
#include <rayscope/diagnostics.h>
#include "base/check_argument.h"
#include "base/printable_text.h"
#include "measure/statistics/deadline.h"
#include "measure/trade/candidates.h"
#include "measure/trade/content_hash.h"
#include "render/check_request.h"
#include "render/film.h"

namespace rayscope::measure {

namespace {

/// Longest time of one picture as a fraction of the budget. The reference takes half of the budget, and
/// errors fall at least with the root of time, so that its error stays well below that of the picture.
constexpr double kMaxPictureFraction = 0.01;
/// The same for the base: some fifty candidates of about its cost are measured in seven blocks.
constexpr double kMaxBaseFraction = 0.0015;
constexpr int kMaxBlocks = 32, kMinBlocks = 7;
/// Only these blocks compute FLIP, which can take longer than the picture; not the first, which measures the
/// duration of a block.
constexpr int kFirstWithFlip = 1, kLastWithFlip = 3;
constexpr std::uint64_t kFirstSeed = 1;

/// Whether the settings need another BVH than the base. The base builds its own, to measure the time.
bool rebuildsBvh(const TradePoint& point, const Settings& base) {
    return point.role == TradeRole::Base || changed(base, point.settings) == Invalidates::Accel;
}

}  // namespace

TradeStudy::TradeStudy(const TradeRequest& request)
    : request_(request), workers_(request.threads), start_(std::chrono::steady_clock::now()) {
    result_.scene = request.render.scene->path;
    result_.userSettings = request.render.settings;
    result_.width = request.render.width;
    result_.height = request.render.height;
    result_.threads = workers_.count();
    result_.budgetSeconds = request.budgetSeconds;
}

double TradeStudy::elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

trace::CompileRequest TradeStudy::compileRequest(const Settings& settings) const {
    return {request_.render.scene, settings, request_.render.camera, result_.width, result_.height};
}

void TradeStudy::reportProgress(const std::string& phase) const {
    if (!request_.progress) return;
    const double done = std::min(elapsed() / request_.budgetSeconds, 1.0);
    request_.progress({phase, done, std::max(0.0, request_.budgetSeconds - elapsed())});
}

TradeResult TradeStudy::run() {
    const SceneRequirements requirements = requirementsOf(*request_.render.scene);
    for (const std::string_view key : settingKeys())
        if (!inactiveReason(requirements, key).empty()) result_.inactiveSettings.emplace_back(key);
    if (pilot()) {
        buildReference();
        result_.points = candidatesFor(requirements, base_, request_);
        runs_.resize(result_.points.size());
        firstBlock();
        laterBlocks();
        summarizeTrade(result_, runs_, requirements);
    }
    result_.interrupted = stopped();
    if (result_.interrupted)
        result_.remarks.push_back("interrupted: the report holds the measurements until then");
    result_.spentSeconds = elapsed();
    return std::move(result_);
}

/// Renders one sample per pixel, and from its time chooses the samples per pixel of the base. Returns false
/// if even one sample per pixel takes too long for the budget.
bool TradeStudy::pilot() {
    reportProgress("pilot");
    base_ = request_.render.settings;
    base_.spp = 1;
    maxSeconds_ = kMaxPictureFraction * request_.budgetSeconds;
    world_ = workers_.run([&] { return trace::compile(compileRequest(base_), nullptr, request_.stop); });
    std::optional<TimedRender> timed;
    for (int warmUp = 0; warmUp < 2 && !stopped(); ++warmUp)
        timed = renderTimed(workers_, compileRequest(base_), world_.get(), kFirstSeed,
                            0.25 * request_.budgetSeconds, request_.stop);
    if (stopped()) return false;
    if (!timed || timed->seconds > 4.0 * maxSeconds_) {
        const double needed = timed ? timed->seconds / (4.0 * kMaxPictureFraction) : request_.budgetSeconds;
        result_.remarks.push_back(
            fmt::format("the budget is too short: one sample per pixel takes {}{:.2g} s; use {} {:.0f} s, or "
                        "a smaller image",
                        timed ? "" : "more than ", timed ? timed->seconds : 0.25 * needed,
                        timed ? "at least" : "more than", std::ceil(needed)));
        return false;
    }
    while (2 * base_.spp <= request_.render.settings.spp &&
           2.0 * base_.spp * timed->seconds < kMaxBaseFraction * request_.budgetSeconds)
        base_.spp *= 2;
    // The time of a candidate is not known in advance, so up to twice the time is tried.
    maxSeconds_ = std::max(maxSeconds_, 2.0 * timed->seconds);
    return true;
}

void TradeStudy::loadReference(const std::string& file) {
    try {
        result_.reference.fromCache = reference_->load(file);
    } catch (const InputError& error) {
        result_.remarks.push_back(fmt::format("the cached reference {} was ignored: it {}",
                                              base::quoted(file), error.diagnostic().message));
    }
}

void TradeStudy::buildReference() {
    TradeReference& about = result_.reference;
    const double begin = elapsed(), end = begin + 0.5 * (request_.budgetSeconds - begin);
    reference_ = std::make_unique<ReferenceImage>(compileRequest(referenceSettings(base_)), workers_,
                                                  world_.get(), request_.stop);
    const std::string file =
        request_.cacheFolder.empty() ? "" : request_.cacheFolder + "/" + reference_->contentHash() + ".films";
    if (!file.empty()) loadReference(file);
    double lastSeconds = 0.0;
    for (int target = std::max(4, 2 * reference_->samples()); target <= 1 << 20 && !stopped(); target *= 2) {
        reportProgress("reference");
        if (elapsed() + 2.0 * lastSeconds > end && reference_->samples() > 0) break;
        const double before = elapsed();
        // The duration of the first step from a cached film is unknown, so it may be cut off.
        const Deadline deadline(std::max(end - before, 0.0) + 1e-3, request_.stop);
        if (!reference_->extend(target, deadline.token())) break;
        lastSeconds = elapsed() - before;
        about.history.push_back({target, reference_->error()});
    }
    if (!file.empty()) {
        try {
            reference_->save(file);
        } catch (const InputError& error) {
            result_.remarks.push_back(fmt::format("the reference was not saved: {}", error.what()));
        }
    }
    about.samples = reference_->samples();
    about.error = reference_->error();
    about.seconds = elapsed() - begin;
    about.nonFinitePixels = reference_->nonFinitePixels();
    about.converges = converges(about.history);
    if (!about.converges)
        result_.remarks.push_back(fmt::format(
            "the reference does not converge: four times the samples reduced its error only from {:.3g} to "
            "{:.3g}; rare bright samples are the usual cause",
            about.history[about.history.size() - 3].second, about.error));
    if (about.nonFinitePixels > 0)
        result_.remarks.push_back(fmt::format(
            "{} pixels of the reference are non-finite and left out; 'rayscope render' lists them",
            about.nonFinitePixels));
    halfA_ = reference_->half(0);
    halfB_ = reference_->half(1);
    mean_ = reference_->mean();
}

/// Renders the candidates by increasing cost and drops those that are too slow for the budget.
void TradeStudy::firstBlock() {
    const double begin = elapsed(), blockBudget = (request_.budgetSeconds - begin) / (kMinBlocks + 1);
    int tooExpensive = 0;
    for (std::size_t i = 0; i < runs_.size() && !stopped(); ++i) {
        reportProgress("first block");
        const TradeRole role = result_.points[i].role;
        const bool combination = role == TradeRole::Combination;
        const bool required =
            role == TradeRole::Base || role == TradeRole::Control || role == TradeRole::Extra;
        const bool skipped =
            !required && (elapsed() - begin > blockBudget || (combination && tooExpensive >= 3));
        runs_[i].dropped = skipped || !measure(i, 0, required ? 1e9 : 2.0 * maxSeconds_);
        if (combination && runs_[i].dropped) ++tooExpensive;
        if (runs_[i].dropped && !stopped()) result_.notMeasured.push_back(result_.points[i].name);
    }
    result_.blocks = 1;
}

void TradeStudy::laterBlocks() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < runs_.size(); ++i)
        if (!runs_[i].dropped) order.push_back(i);
    std::mt19937_64 random(1);
    for (int block = 1; block < kMaxBlocks && !stopped(); ++block) {
        std::shuffle(order.begin(), order.end(), random);
        for (const std::size_t i : order) {
            reportProgress(fmt::format("block {}", block + 1));
            if (stopped() || (elapsed() > request_.budgetSeconds && block > 1)) return;
            measure(i, block, 1e9);
        }
        result_.blocks = block + 1;
    }
}

bool TradeStudy::measure(std::size_t index, int block, double maxSeconds) {
    const TradePoint& point = result_.points[index];
    CandidateRuns& runs = runs_[index];
    const trace::World* previous = rebuildsBvh(point, base_) ? nullptr : world_.get();
    const std::optional<TimedRender> timed =
        renderTimed(workers_, compileRequest(point.settings), previous,
                    kFirstSeed + static_cast<std::uint64_t>(block), maxSeconds, request_.stop);
    if (!timed) return false;
    runs.seconds.push_back(request_.secondsOfRays ? request_.secondsOfRays(timed->rays) : timed->seconds);
    runs.buildSeconds.push_back(timed->buildSeconds);
    if (block == 0) runs.work = workOf(*timed);
    runs.imageHashes.push_back(imageContentHash(timed->image));
    measureErrors(*timed, runs, block);
    return true;
}

/// Counts traversal steps in a separate, untimed pass.
TradeWork TradeStudy::workOf(const TimedRender& timed) const {
    constexpr Aov kCounted[] = {Aov::Nodes, Aov::Triangles, Aov::Rays};
    const AovRequest once{*timed.world, nullptr, kFirstSeed, 1, std::nullopt, workers_.count()};
    const std::vector<RgbImage> counts = renderAovs(once, kCounted);
    const auto sum = [](const RgbImage& image) {
        double total = 0.0;
        for (const Rgb& pixel : image.pixels) total += static_cast<double>(pixel.x);
        return total;
    };
    const double rays = std::max(1.0, sum(counts[2]));
    const auto samples = static_cast<std::uint64_t>(timed.world->settings.spp) * timed.image.pixels.size();
    return {samples, timed.rays, sum(counts[0]) / rays, sum(counts[1]) / rays};
}

void TradeStudy::measureErrors(const TimedRender& timed, CandidateRuns& runs, int block) {
    runs.squaredErrors.push_back(meanSquaredError(timed.image, halfA_, halfB_));
    if (block >= kFirstWithFlip && block <= kLastWithFlip)
        runs.flips.push_back(scoreOf(errorMap(timed.image, mean_, ErrorMetric::Flip), ErrorMetric::Flip));
    if (block % 2 == 0) {
        runs.previous = timed.image;
        return;
    }
    const double squaredBias = meanErrorProduct(timed.image, runs.previous, halfA_, halfB_);
    const std::size_t last = runs.squaredErrors.size() - 1;
    runs.squaredBiases.push_back(squaredBias);
    runs.squaredNoises.push_back(0.5 * (runs.squaredErrors[last - 1] + runs.squaredErrors[last]) -
                                 squaredBias);
    runs.previous = {};
}

}  // namespace rayscope::measure

namespace rayscope {

TradeResult measureTrade(const TradeRequest& request) {
    RenderRequest whole = request.render;
    whole.region.reset();  // ignored
    render::checkRequest(whole);
    for (const auto& [name, settings] : request.extra) checkSettings(settings);
    base::checkArgument(request.budgetSeconds >= 0.0 && std::isfinite(request.budgetSeconds),
                        "budgetSeconds is {}; expected a finite number of at least 0", request.budgetSeconds);
    return measure::TradeStudy(request).run();
}

}  // namespace rayscope
