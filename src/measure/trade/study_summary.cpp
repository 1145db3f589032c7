#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "measure/statistics/statistics.h"
#include "measure/trade/parameters.h"
#include "measure/trade/pareto.h"
#include "measure/trade/study.h"

namespace rayscope::measure {

namespace {

/// The prediction interval of the next value, for positive values with a roughly log-normal distribution.
Interval positivePredictionInterval(const std::vector<double>& values) {
    std::vector<double> logarithms;
    logarithms.reserve(values.size());
    for (const double value : values) logarithms.push_back(std::log(std::max(value, 1e-300)));
    const Interval next = predictionInterval(logarithms);
    return {std::exp(next.value), std::exp(next.lower), std::exp(next.upper)};
}

std::vector<double> products(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> result;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) result.push_back(a[i] * b[i]);
    return result;
}

void summarizePoint(TradePoint& point, const CandidateRuns& runs, const CandidateRuns& base,
                    double referenceError) {
    point.runs = static_cast<int>(runs.seconds.size());
    if (point.runs == 0) return;
    point.work = runs.work;
    point.seconds = medianInterval(runs.seconds);
    point.buildSeconds = medianInterval(runs.buildSeconds);
    point.error = rootOf(meanInterval(runs.squaredErrors));
    if (!runs.flips.empty()) point.flip = meanInterval(runs.flips);
    point.flip.lower = std::max(point.flip.lower, 0.0);
    point.flip.upper = std::min(point.flip.upper, 1.0);
    point.timeRatio = ratioInterval(runs.seconds, base.seconds);
    point.efficiency =
        ratioInterval(products(base.squaredErrors, base.seconds), products(runs.squaredErrors, runs.seconds));
    point.predictedSeconds = positivePredictionInterval(runs.seconds);
    point.predictedError = rootOf(predictionInterval(runs.squaredErrors));
    point.reliable = point.error.value >= 10.0 * referenceError;
    const std::size_t common = std::min(runs.imageHashes.size(), base.imageHashes.size());
    point.samePicture =
        std::equal(runs.imageHashes.begin(), runs.imageHashes.begin() + static_cast<std::ptrdiff_t>(common),
                   base.imageHashes.begin());
    if (runs.squaredBiases.empty()) return;
    point.bias = rootOf(meanInterval(runs.squaredBiases));
    point.noise = rootOf(meanInterval(runs.squaredNoises));
    point.biased = point.bias.lower > referenceError;
}

/// d log error / d log samples per pixel, from the slopes of the blocks.
Interval convergence(const TradeResult& result, const std::vector<CandidateRuns>& runs) {
    std::vector<std::size_t> chosen{0};
    for (std::size_t i = 1; i < runs.size(); ++i)
        if (result.points[i].parameter == "spp" && result.points[i].reliable) chosen.push_back(i);
    if (chosen.size() < 3 || !result.points[0].reliable) return {};
    std::vector<double> slopes;
    for (std::size_t block = 0; block < static_cast<std::size_t>(result.blocks); ++block) {
        std::vector<double> x, y;
        for (const std::size_t i : chosen) {
            if (block >= runs[i].squaredErrors.size() || !(runs[i].squaredErrors[block] > 0.0)) continue;
            x.push_back(std::log(result.points[i].settings.spp));
            y.push_back(0.5 * std::log(runs[i].squaredErrors[block]));
        }
        if (x.size() >= 3) slopes.push_back(slopeOf(x, y));
    }
    return slopes.size() >= 2 ? meanInterval(slopes) : Interval{};
}

TradeBreakEven breakEvenOf(std::size_t index, const CandidateRuns& runs, const CandidateRuns& base) {
    std::vector<double> builds, savings, evens;
    for (std::size_t b = 0; b < std::min(runs.seconds.size(), base.seconds.size()); ++b) {
        builds.push_back(runs.buildSeconds[b] - base.buildSeconds[b]);
        savings.push_back(base.seconds[b] / static_cast<double>(base.work.rays) -
                          runs.seconds[b] / static_cast<double>(runs.work.rays));
        evens.push_back(builds.back() / savings.back());
    }
    const Interval extraBuild = meanInterval(builds), saved = meanInterval(savings);
    TradeBreakEven even{index, {}, ""};
    if (extraBuild.contains(0.0) || saved.contains(0.0))
        even.text = fmt::format("no significant difference in {} time from the base",
                                saved.contains(0.0) ? "tracing" : "build");
    else if ((extraBuild.value > 0.0) != (saved.value > 0.0))
        even.text = saved.value > 0.0 ? "faster to build and to trace" : "slower to build and to trace";
    else {
        even.rays = medianInterval(evens);
        even.text = fmt::format("faster in total {} {:.2g} [{:.2g}, {:.2g}] rays",
                                saved.value > 0.0 ? "above" : "below", even.rays.value, even.rays.lower,
                                even.rays.upper);
    }
    return even;
}

void findEffects(TradeResult& result, const SceneRequirements& scene) {
    for (const Effect& effect : effectsOf(scene, result.points.front().settings)) {
        const auto measured = std::find_if(
            result.points.begin(), result.points.end(),
            [&](const TradePoint& p) { return p.role == TradeRole::Effect && p.parameter == effect.key; });
        if (measured == result.points.end()) continue;
        result.effects.push_back({std::string(effect.key), std::string(effect.label), effect.on,
                                  effect.reason, static_cast<std::size_t>(measured - result.points.begin())});
    }
}

void addRemarks(TradeResult& result) {
    const double ten = 10.0 * result.reference.error;
    const auto unreliable = std::count_if(result.points.begin(), result.points.end(),
                                          [](const TradePoint& p) { return p.runs > 0 && !p.reliable; });
    if (unreliable > 0)
        result.remarks.push_back(fmt::format(
            "{} errors are not reliable: they are below {:.3g}, ten times the error of the reference",
            unreliable, ten));
    if (!result.complete)
        result.remarks.push_back(
            "no candidate was measured twice, so there are no intervals; use a larger budget");
}

}  // namespace

void summarizeTrade(TradeResult& result, const std::vector<CandidateRuns>& runs,
                    const SceneRequirements& scene) {
    if (runs.empty() || runs.front().seconds.empty()) return;
    for (std::size_t i = 0; i < runs.size(); ++i)
        summarizePoint(result.points[i], runs[i], runs.front(), result.reference.error);
    result.complete = result.points.front().runs >= 2;
    const Interval& control = result.points[1].timeRatio;
    result.smallestTimeDifference = std::max(control.upper, 1.0 / control.lower) - 1.0;
    result.convergenceSlope = convergence(result, runs);
    result.paretoFront = markParetoFront(result.points, result.smallestTimeDifference);
    result.advice = adviceFrom(result.points, result.paretoFront);
    for (std::size_t i = 1; i < runs.size(); ++i)
        if (result.points[i].role == TradeRole::Parameter && result.points[i].runs >= 2 &&
            changed(result.points[0].settings, result.points[i].settings) == Invalidates::Accel)
            result.breakEvens.push_back(breakEvenOf(i, runs[i], runs.front()));
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (result.points[i].role == TradeRole::Preset && result.points[i].runs >= 2)
            result.presetPoints.push_back({result.points[i].level, i, excessTime(result, i)});
    findEffects(result, scene);
    addRemarks(result);
}

}  // namespace rayscope::measure
