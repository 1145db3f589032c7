#pragma once
// The trade of speed for accuracy, measured on a scene of the user's own.
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

/// Why settings were measured.
enum class TradeRole {
    Base,          ///< the settings that the others are compared with
    Control,       ///< the base once more: what differs between the two is the noise of the machine
    UserSettings,  ///< exactly what was userSettings for
    Parameter,     ///< the base with one knob turned
    Combination,   ///< several knobs turned
    Feature,       ///< the base with an effect switched on or off
    Preset,        ///< a position of the presetPoints
    Extra          ///< what the caller added
};

/// The work of one run: counted, so the same whatever the machine does, and in other runs up to the noise of
/// the samples.
struct TradeWork {
    std::uint64_t samples = 0;  ///< of pixels
    std::uint64_t rays = 0;     ///< of all kinds
    /// Boxes of the binary tree entered, and triangles and spheres tested, by a ray on average: over the rays
    /// of the first sample of each pixel.
    double nodesPerRay = 0.0, testsPerRay = 0.0;
};

/// Settings that were measured, and what came out. Errors are RMSE of linear values against the reference.
struct TradePoint {
    TradeRole role = TradeRole::Base;
    std::string name;         ///< what differs from the base, in words
    std::string knob, level;  ///< of Parameter and Feature
    Settings settings;
    int runs = 0;  ///< interleaved with those of all others, each with another seed
    TradeWork work;

    Interval seconds;       ///< median, tracing and bloom
    Interval buildSeconds;  ///< median, of hierarchies; only where they differ from the base's
    Interval error;         ///< of a single picture
    Interval noise, bias;   ///< error² = noise² + bias²: bias is what more samples would not take away
    Interval flip;          ///< mean FLIP, what a person would see
    Interval timeRatio;     ///< to the base, in pairs
    Interval efficiency;    ///< 1 / (error² · seconds) relative to the base
    Interval nextSeconds, nextError;  ///< where one more run will lie

    bool reliable = false;       ///< the reference's own error is at most a tenth of this error
    bool biased = false;         ///< the bias is real: its interval lies above what the reference can hide
    bool samePicture = false;    ///< every run gave the base's picture, bit for bit
    bool onParetoFront = false;  ///< nothing measured is both faster and more accurate
    std::string dominatedBy;     ///< the name of a point that is better in both beyond doubt, or empty
};

/// Where the truth comes from: two independent halves, whose difference tells their own error.
struct TradeReference {
    int samples = 0;     ///< per pixel and half
    double error = 0.0;  ///< RMSE of the mean of both halves
    double seconds = 0.0;
    bool fromCache = false, converges = true;
    std::vector<std::pair<int, double>> history;  ///< samples per half and error, as it grew
    long long nonFinitePixels = 0;
};

/// How far a position of the presetPoints is from the front of this scene.
struct TradePreset {
    std::string preset;
    std::size_t point;
    double excess =
        0.0;  ///< time beyond that of the front at the same error: 0.1 is 10 % more; 0 on the front
};

/// What the scene needs of an effect.
struct TradeEffect {
    std::string key, label;
    bool on = false;
    std::string reason;  ///< why it cannot matter, or empty if it was measured
    std::size_t point;   ///< the measurement with the effect switched over
};

/// Rays from which on the slower build is paid back by faster rays, against the base.
struct TradeBreakEven {
    std::size_t point;
    Interval rays;  ///< empty (all 0) if neither ever catches up
    std::string words;
};

/// The best measured settings that fit into a time.
struct TradeAdvice {
    double budgetSeconds = 0.0;
    std::size_t point;
};

struct TradeResult {
    std::string scene;
    Settings userSettings;  ///< the user's
    int width = 0, height = 0, threads = 0, blocks = 0;
    double budgetSeconds = 0.0, spentSeconds = 0.0;
    std::vector<TradePoint> points;  ///< the base first
    TradeReference reference;
    double smallestRatio = 0.0;  ///< the least difference in time that can be told from the machine's noise
    Interval slope;              ///< of log error over log samples per pixel; all 0 if not measured
    std::vector<std::size_t> front;  ///< from fast to accurate
    std::vector<TradeAdvice> advice;
    std::vector<TradeEffect> needs;
    std::vector<TradePreset> presetPoints;
    std::vector<TradeBreakEven> breakEvens;
    std::vector<std::string> withoutEffect;  ///< keys of settings that cannot matter in this scene
    std::vector<std::string> notMeasured;    ///< names of settings that did not fit into the budget
    std::vector<std::string> remarks;        ///< what the reader should know before trusting a figure
    bool complete = false;                   ///< at least one point was measured twice
    bool interrupted = false;
};

struct TradeProgress {
    std::string phase;
    double fraction = 0.0, remainingSeconds = 0.0;
};

struct TradeRequest {
    RenderRequest render;  ///< its settings are the user's; region and progressive are ignored
    double budgetSeconds = 60.0;
    int threads = 0;
    std::string cacheFolder;  ///< for references; empty: none are kept
    std::vector<std::pair<std::string, Settings>> extra;
    std::function<void(const TradeProgress&)> progress;
    std::stop_token stop;
    /// The seconds that a picture of so many rays counts as, so that a report can be had whose times do not
    /// depend on the machine; empty: what it took.
    std::function<double(std::uint64_t rays)> secondsOfRays;
};

/// Measures for about `budgetSeconds`. Throws InputError if the scene cannot be traced. If the budget is too
/// short, or a stop is requested, the result holds what was measured until then and says so.
TradeResult measureTrade(const TradeRequest& request);

/// The point that has these settings, as far as they matter in the scene; nothing if none was measured.
std::optional<std::size_t> measuredPoint(const TradeResult& result, const Settings& settings);

/// How much longer a point takes than the front needs for its error: 0.1 is 10 % more; 0 on the front.
double excessTime(const TradeResult& result, std::size_t point);

/// By how much a position of the presetPoints is behind the front, and whether that may be the noise of the
/// machine: unless something measured is better in both time and error beyond doubt.
std::string excessText(const TradeResult& result, const TradePreset& presetPoints);

/// The folder for references in the user's cache ($XDG_CACHE_HOME or ~/.cache), or "" if there is none.
std::string referenceCacheFolder();

/// The arguments of `rayscope render` that reproduce a point, without scene and camera: "--size … --set …".
std::string renderArguments(const TradeResult& result, const TradePoint& point);

std::string tradeJson(const TradeResult& result);
std::string tradeCsv(const TradeResult& result);
/// One page with charts, which needs no other file.
std::string tradeHtml(const TradeResult& result);

}  // namespace rayscope
