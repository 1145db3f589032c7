#include "measure/trade/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include <rayscope/compare.h>
#include <rayscope/diagnostics.h>
#include "measure/trade/candidates.h"
#include "measure/trade/content_hash.h"
#include "probe/aov.h"
#include "render/film.h"
#include "sampling/hash.h"

namespace rayscope::measure {

namespace {

/// A picture whose error the reference can judge takes at most this part of the budget: the reference gets
/// half of it, and errors fall with the root of time or faster.
constexpr double kPartOfBudget = 0.01;
/// The base takes less, since some fifty candidates in seven blocks take about as long.
constexpr double kPartOfBase = 0.0015;
constexpr int kMaxBlocks = 32, kMinBlocks = 7;
/// FLIP takes longer than many a picture: only these blocks look at it, and not the first, which finds out
/// what a block takes.
constexpr int kFirstWithFlip = 1, kLastWithFlip = 3;
constexpr std::uint64_t kFirstSeed = 1;

std::uint64_t hashOf(const RgbImage& image) {
    std::uint64_t hash = 0;
    for (const Rgb& c : image.pixels) {
        std::uint32_t words[3];
        std::memcpy(words, &c, sizeof words);
        hash = sampling::hashPair(
            hash, sampling::hashPair(words[0], (static_cast<std::uint64_t>(words[1]) << 32) | words[2]));
    }
    return hash;
}

/// Whether the hierarchy of these settings is another than that of the base.
bool buildsAnew(const TradePoint& point, const Settings& base) {
    return point.role == TradeRole::Base || changed(base, point.settings) == Invalidates::Accel;
}

}  // namespace

Experiment::Experiment(const TradeRequest& request)
    : request_(request), workers_(request.threads), start_(std::chrono::steady_clock::now()) {
    result_.scene = request.render.scene->path;
    result_.userSettings = request.render.settings;
    result_.width = request.render.width;
    result_.height = request.render.height;
    result_.threads = workers_.count();
    result_.budgetSeconds = request.budgetSeconds;
}

double Experiment::elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

trace::CompileRequest Experiment::compileRequest(const Settings& settings) const {
    return {request_.render.scene, settings, request_.render.camera, result_.width, result_.height};
}

void Experiment::report(const std::string& phase) const {
    if (!request_.progress) return;
    const double done = std::min(elapsed() / request_.budgetSeconds, 1.0);
    request_.progress({phase, done, std::max(0.0, request_.budgetSeconds - elapsed())});
}

TradeResult Experiment::run() {
    const SceneRequirements needs = requirementsOf(*request_.render.scene);
    for (const std::string_view key : settingKeys())
        if (!inactiveReason(needs, key).empty()) result_.withoutEffect.emplace_back(key);
    if (pilot()) {
        buildReference();
        result_.points = candidatesFor(needs, base_, request_);
        runs_.resize(result_.points.size());
        firstBlock();
        laterBlocks();
        summarize(result_, runs_, needs);
    }
    result_.interrupted = stopped();
    if (result_.interrupted)
        result_.remarks.push_back("interrupted: only what was measured until then is reported");
    result_.spentSeconds = elapsed();
    return std::move(result_);
}

/// Renders one sample per pixel and chooses as many of them for the base as a picture may take. Returns false
/// if not even that many fit.
bool Experiment::pilot() {
    report("pilot");
    base_ = request_.render.settings;
    base_.spp = 1;
    maxSeconds_ = kPartOfBudget * request_.budgetSeconds;
    world_ = workers_.run([&] { return trace::compile(compileRequest(base_), nullptr, request_.stop); });
    std::optional<Trial> trial;
    for (int warmUp = 0; warmUp < 2 && !stopped(); ++warmUp)
        trial = runTrial(workers_, compileRequest(base_), world_.get(), kFirstSeed,
                         0.25 * request_.budgetSeconds, request_.stop);
    if (stopped()) return false;
    if (!trial || trial->seconds > 4.0 * maxSeconds_) {
        const double needed = trial ? trial->seconds / (4.0 * kPartOfBudget) : request_.budgetSeconds;
        result_.remarks.push_back(
            fmt::format("the budget is too short to measure anything: one sample per pixel takes {} {:.2g} "
                        "s; give {} {:.0f} s, or "
                        "a smaller image",
                        trial ? "" : "more than", trial ? trial->seconds : 0.25 * needed,
                        trial ? "at least" : "more than", std::ceil(needed)));
        return false;
    }
    while (2 * base_.spp <= request_.render.settings.spp &&
           2.0 * base_.spp * trial->seconds < kPartOfBase * request_.budgetSeconds)
        base_.spp *= 2;
    // Twice as long is still tried: what a knob costs is not known before.
    maxSeconds_ = std::max(maxSeconds_, 2.0 * trial->seconds);
    return true;
}

void Experiment::buildReference() {
    TradeReference& about = result_.reference;
    const double begin = elapsed(), end = begin + 0.5 * (request_.budgetSeconds - begin);
    reference_ = std::make_unique<Reference>(compileRequest(referenceSettings(base_)), workers_, world_.get(),
                                             request_.stop);
    const std::string file =
        request_.cacheFolder.empty() ? "" : request_.cacheFolder + "/" + reference_->contentHash() + ".films";
    about.fromCache = !file.empty() && reference_->load(file);
    double lastSeconds = 0.0;
    for (int target = std::max(4, 2 * reference_->samples()); target <= 1 << 20 && !stopped(); target *= 2) {
        report("reference");
        if (elapsed() + 2.0 * lastSeconds > end && reference_->samples() > 0) break;
        const double before = elapsed();
        // The first step of a cached film has no precedent for its time: let it end early.
        const Deadline deadline(std::max(end - before, 0.0) + 1e-3, request_.stop);
        if (!reference_->extend(target, deadline.token())) break;
        lastSeconds = elapsed() - before;
        about.history.push_back({target, reference_->error()});
    }
    if (!file.empty()) {
        try {
            reference_->save(file);
        } catch (const InputError& error) {
            result_.remarks.push_back(fmt::format("the reference could not be kept: {}", error.what()));
        }
    }
    about.samples = reference_->samples();
    about.error = reference_->error();
    about.seconds = elapsed() - begin;
    about.nonFinitePixels = reference_->nonFinitePixels();
    about.converges = converges(about.history);
    if (!about.converges)
        result_.remarks.push_back(fmt::format(
            "the reference does not converge: with four times the samples its error only went from "
            "{:.3g} to {:.3g}; rare bright samples are the usual cause",
            about.history[about.history.size() - 3].second, about.error));
    if (about.nonFinitePixels > 0)
        result_.remarks.push_back(
            fmt::format("{} pixels of the reference are NaN or infinite and are left out; "
                        "'rayscope render' names them",
                        about.nonFinitePixels));
    halfA_ = reference_->half(0);
    halfB_ = reference_->half(1);
    mean_ = reference_->mean();
}

/// Goes through the candidates from cheap to dear and finds out which the budget can afford.
void Experiment::firstBlock() {
    const double begin = elapsed(), afford = (request_.budgetSeconds - begin) / (kMinBlocks + 1);
    int tooExpensive = 0;
    for (std::size_t i = 0; i < runs_.size() && !stopped(); ++i) {
        report("first block");
        const TradeRole role = result_.points[i].role;
        const bool joint = role == TradeRole::Combination;
        const bool wanted = role == TradeRole::Base || role == TradeRole::Control || role == TradeRole::Extra;
        const bool skipped = !wanted && (elapsed() - begin > afford || (joint && tooExpensive >= 3));
        runs_[i].dropped = skipped || !measure(i, 0, wanted ? 1e9 : 2.0 * maxSeconds_);
        if (joint && runs_[i].dropped) ++tooExpensive;
        if (runs_[i].dropped && !stopped()) result_.notMeasured.push_back(result_.points[i].name);
    }
    result_.blocks = 1;
}

void Experiment::laterBlocks() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < runs_.size(); ++i)
        if (!runs_[i].dropped) order.push_back(i);
    std::mt19937_64 random(1);
    for (int block = 1; block < kMaxBlocks && !stopped(); ++block) {
        std::shuffle(order.begin(), order.end(), random);
        for (const std::size_t i : order) {
            report(fmt::format("block {}", block + 1));
            if (stopped() || (elapsed() > request_.budgetSeconds && block > 1)) return;
            measure(i, block, 1e9);
        }
        result_.blocks = block + 1;
    }
}

bool Experiment::measure(std::size_t index, int block, double maxSeconds) {
    const TradePoint& point = result_.points[index];
    CandidateRuns& runs = runs_[index];
    const trace::World* lender = buildsAnew(point, base_) ? nullptr : world_.get();
    const std::optional<Trial> trial =
        runTrial(workers_, compileRequest(point.settings), lender,
                 kFirstSeed + static_cast<std::uint64_t>(block), maxSeconds, request_.stop);
    if (!trial) return false;
    runs.seconds.push_back(request_.secondsOfRays ? request_.secondsOfRays(trial->rays) : trial->seconds);
    runs.buildSeconds.push_back(trial->buildSeconds);
    if (block == 0) runs.work = workOf(*trial);
    runs.pictures.push_back(hashOf(trial->image));
    judge(*trial, runs, block);
    return true;
}

/// The walks through the tree are counted after the clock has stopped.
TradeWork Experiment::workOf(const Trial& trial) const {
    constexpr probe::Aov kCounted[] = {probe::Aov::Nodes, probe::Aov::Triangles, probe::Aov::Rays};
    const probe::AovRequest once{*trial.world, nullptr, kFirstSeed, 1, std::nullopt, workers_.count()};
    const std::vector<RgbImage> counts = probe::renderAovs(once, kCounted);
    const auto sum = [](const RgbImage& image) {
        double total = 0.0;
        for (const Rgb& pixel : image.pixels) total += static_cast<double>(pixel.x);
        return total;
    };
    const double rays = std::max(1.0, sum(counts[2]));
    const auto samples = static_cast<std::uint64_t>(trial.world->settings.spp) * trial.image.pixels.size();
    return {samples, trial.rays, sum(counts[0]) / rays, sum(counts[1]) / rays};
}

void Experiment::judge(const Trial& trial, CandidateRuns& runs, int block) {
    runs.squaredErrors.push_back(meanSquaredError(trial.image, halfA_, halfB_));
    if (block >= kFirstWithFlip && block <= kLastWithFlip)
        runs.flips.push_back(scoreOf(errorMap(trial.image, mean_, ErrorMetric::Flip), ErrorMetric::Flip));
    if (block % 2 == 0) {
        runs.previous = trial.image;
        return;
    }
    const double common = commonSquaredError(trial.image, runs.previous, halfA_, halfB_);
    const std::size_t last = runs.squaredErrors.size() - 1;
    runs.common.push_back(common);
    runs.squaredNoise.push_back(0.5 * (runs.squaredErrors[last - 1] + runs.squaredErrors[last]) - common);
    runs.previous = {};
}

}  // namespace rayscope::measure

namespace rayscope {

TradeResult measureTrade(const TradeRequest& request) { return measure::Experiment(request).run(); }

}  // namespace rayscope
