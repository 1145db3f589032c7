#pragma once
// Study of rendering time against error on one scene: which settings to use, and what each parameter does.
#include <rayscope/interval.h>
#include <rayscope/render_session.h>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace rayscope {

/// Why a candidate is measured.
enum class TradeRole {
    Base,          ///< the settings that the others are compared with
    Control,       ///< the base again; the difference between the two is the timing noise of the machine
    UserSettings,  ///< the settings of the request
    Parameter,     ///< the base with one parameter changed
    Combination,   ///< several parameters changed
    Effect,        ///< the base with an effect switched on or off
    Preset,        ///< the user settings with a preset applied
    Extra          ///< TradeRequest::extra
};

/// Work of one picture. It is counted, not timed, so it does not depend on the machine.
struct TradeWork {
    std::uint64_t samples = 0;  ///< of pixels
    std::uint64_t rays = 0;     ///< of all kinds
    /// Nodes visited and primitives tested per ray, as the AOVs count them, over the first sample of each
    /// pixel.
    double nodesPerRay = 0.0, testsPerRay = 0.0;
};

/// A candidate and its measurements. Errors are RMSE of linear values against the reference image.
struct TradePoint {
    TradeRole role = TradeRole::Base;
    std::string name;              ///< the settings that differ from the base, for people
    std::string parameter, level;  ///< key and value, for Parameter and Effect
    Settings settings;
    int runs = 0;  ///< interleaved with those of all other candidates, each with another seed
    TradeWork work;

    Interval seconds;       ///< median, of tracing and bloom
    Interval buildSeconds;  ///< median, of BVHs; only where they differ from those of the base
    Interval error;         ///< of a single picture
    Interval noise, bias;   ///< error² = noise² + bias²; bias is the part that more samples do not reduce
    Interval flip;          ///< mean FLIP
    Interval timeRatio;     ///< to the base, in pairs of the same block
    Interval efficiency;    ///< 1 / (error² · seconds) relative to the base
    Interval predictedSeconds, predictedError;  ///< prediction intervals of one more run

    bool reliable = false;       ///< the error is at least ten times that of the reference
    bool biased = false;         ///< the lower end of the bias is above the error of the reference
    bool samePicture = false;    ///< every run is bit-identical to the base's of the same seed
    bool onParetoFront = false;  ///< no other candidate is both faster and more accurate
    std::string dominatedBy;     ///< name of a candidate that is significantly better in both, or empty
};

/// The reference image: the mean of two independent halves, whose difference gives its error.
struct TradeReference {
    int samples = 0;     ///< per pixel and half
    double error = 0.0;  ///< RMSE of the mean of both halves
    double seconds = 0.0;
    bool fromCache = false, converges = true;
    std::vector<std::pair<int, double>> history;  ///< samples per half, and error, at each doubling
    long long nonFinitePixels = 0;
};

/// Distance of a preset to the Pareto front of this scene.
struct TradePreset {
    std::string preset;
    std::size_t point;  ///< index into TradeResult::points
    /// Excess time relative to the front's time at the same error: 0.1 is 10 % more; 0 on the front.
    double excess = 0.0;
};

/// Whether an effect changes the picture of this scene.
struct TradeEffect {
    std::string key, label;
    bool on = false;     ///< in the base
    std::string reason;  ///< why it cannot change the picture, derived from the scene; empty if none is known
    std::size_t point;   ///< the candidate with the effect switched
};

/// Number of rays at which a difference in build time equals the difference in tracing time, against the
/// base.
struct TradeBreakEven {
    std::size_t point;
    Interval rays;  ///< all 0 if there is no such number
    std::string text;
};

/// The most accurate measured settings within a time budget.
struct TradeAdvice {
    double budgetSeconds = 0.0;
    std::size_t point;
};

struct TradeResult {
    std::string scene;
    Settings userSettings;
    int width = 0, height = 0, threads = 0, blocks = 0;
    double budgetSeconds = 0.0, spentSeconds = 0.0;
    std::vector<TradePoint> points;  ///< the base first
    TradeReference reference;
    /// Smallest relative difference in time that exceeds the timing noise of the machine.
    double smallestTimeDifference = 0.0;
    Interval convergenceSlope;             ///< d log error / d log samples per pixel; all 0 if not measured
    std::vector<std::size_t> paretoFront;  ///< from fast to accurate
    std::vector<TradeAdvice> advice;
    std::vector<TradeEffect> effects;
    std::vector<TradePreset> presetPoints;
    std::vector<TradeBreakEven> breakEvens;
    std::vector<std::string> inactiveSettings;  ///< keys of settings without effect in this scene
    std::vector<std::string> notMeasured;       ///< names of candidates that did not fit into the budget
    std::vector<std::string> remarks;           ///< warnings about the validity of the measurements
    bool complete = false;                      ///< the base was measured at least twice
    bool interrupted = false;
};

struct TradeProgress {
    std::string phase;
    double fraction = 0.0, remainingSeconds = 0.0;
};

struct TradeRequest {
    RenderRequest render;  ///< with the user settings; region and progressive are ignored
    double budgetSeconds = 60.0;
    int threads = 0;                                      ///< 0: one per core
    std::string cacheFolder;                              ///< for references; empty: none are kept
    std::vector<std::pair<std::string, Settings>> extra;  ///< additional candidates, with names
    std::function<void(const TradeProgress&)> progress;
    std::stop_token stop;
    /// Replaces the measured seconds of a picture by a function of its rays, for results that do not depend
    /// on the speed of the machine; empty: measured seconds.
    std::function<double(std::uint64_t rays)> secondsOfRays;
};

/// Measures for about `budgetSeconds`. If the budget is too short or a stop is requested, the result holds
/// what was measured until then, with a remark. Throws InputError if the scene cannot be traced.
TradeResult measureTrade(const TradeRequest& request);

/// The measured point whose settings equal these, apart from settings without effect in the scene.
std::optional<std::size_t> measuredPoint(const TradeResult& result, const Settings& settings);

/// Time of a point beyond that of the Pareto front at the same error: 0.1 is 10 % more; 0 on the front.
double excessTime(const TradeResult& result, std::size_t point);

/// The excess time of a preset as text. "not significant" is added if no candidate dominates the preset, so
/// that timing noise may explain the distance.
std::string excessText(const TradeResult& result, const TradePreset& preset);

/// The folder for references in the user's cache ($XDG_CACHE_HOME or ~/.cache), or "" if there is none.
std::string referenceCacheFolder();

/// The arguments of `rayscope render` that reproduce a point, without scene and camera: "--size … --set …".
std::string renderArguments(const TradeResult& result, const TradePoint& point);

std::string tradeJson(const TradeResult& result);
std::string tradeCsv(const TradeResult& result);
/// A page with charts in one file.
std::string tradeHtml(const TradeResult& result);

}  // namespace rayscope
