#include "measure/target/error_monitor.h"

#include <algorithm>
#include <cmath>

namespace rayscope::measure {

namespace {

/// Samples per pixel from which on the target can count as reached.
constexpr int kMinSamples = 8;

/// Two pictures whose mean is the mean of all samples, and whose half difference has the same expected square
/// as the error of that mean. With a and b samples in the halves, the difference of their means has the
/// variance σ² (a + b) / (a b), and the mean of all samples σ² / (a + b); so the difference is scaled by √(a
/// b) / (a + b).
void splitHalves(const ErrorMonitor::Snapshot& before, const ErrorMonitor::Snapshot& now, RgbImage& first,
                 RgbImage& second) {
    for (std::size_t i = 0; i < now.sums.size(); ++i) {
        const double a = before.samples[i], b = now.samples[i] - before.samples[i];
        const RgbSum mean = now.sums[i].radiance / static_cast<double>(now.samples[i]);
        RgbSum difference(0.0);
        if (a > 0.0 && b > 0.0) {
            const RgbSum late = (now.sums[i].radiance - before.sums[i].radiance) / b;
            difference = (before.sums[i].radiance / a - late) * (std::sqrt(a * b) / (a + b));
        }
        first.pixels[i] = Rgb(mean + difference);
        second.pixels[i] = Rgb(mean - difference);
    }
}

}  // namespace

ErrorMonitor::Snapshot ErrorMonitor::snapshotOf(const render::Film& film) {
    const PixelBounds& region = film.region();
    Snapshot snapshot;
    snapshot.width = region.x1 - region.x0;
    const auto count =
        static_cast<std::size_t>(snapshot.width) * static_cast<std::size_t>(region.y1 - region.y0);
    snapshot.sums.resize(count);
    snapshot.samples.resize(count);
    snapshot.completeSamples = film.completeSamples();
    render::Film::TileCopy copy;
    for (int tile = 0; tile < film.tileCount(); ++tile) {
        film.read(tile, copy);
        const PixelBounds bounds = film.tileBounds(tile);
        std::size_t from = 0;
        for (int y = bounds.y0; y < bounds.y1; ++y)
            for (int x = bounds.x0; x < bounds.x1; ++x, ++from) {
                const auto to =
                    static_cast<std::size_t>(y - region.y0) * static_cast<std::size_t>(snapshot.width) +
                    static_cast<std::size_t>(x - region.x0);
                snapshot.sums[to] = copy.pixels[from];
                snapshot.samples[to] = copy.samples;
            }
    }
    return snapshot;
}

bool ErrorMonitor::isEstimateDue(int completeSamples) const {
    return completeSamples >= std::max(1, 2 * before_.completeSamples);
}

void ErrorMonitor::update(Snapshot now) {
    const bool sameFilm = before_.width == now.width && before_.sums.size() == now.sums.size();
    if (sameFilm && now.completeSamples > before_.completeSamples) {
        const int height = static_cast<int>(now.sums.size()) / std::max(1, now.width);
        RgbImage first(now.width, height), second(now.width, height);
        splitHalves(before_, now, first, second);
        trend_.add(now.completeSamples, estimateError(first, second, {0, now.width, 0, height}, target_));
    }
    before_ = std::move(now);
}

bool ErrorMonitor::reached() const {
    return hasEstimate() && trend_.samples() >= kMinSamples && latest().reliable &&
           latest().upper <= target_.error;
}

ErrorForecast ErrorMonitor::forecast(double samples, double seconds, double timeLimit) const {
    ErrorForecast f;
    f.samples = static_cast<int>(samples);
    f.elapsedSeconds = seconds;
    if (!hasEstimate() || !(samples > 0.0)) return f;
    f.estimate = latest();
    const double perSample = seconds / samples;
    if (target_.error > 0.0) {
        // The target can be reached at each doubling of the samples.
        double stop = reached() ? trend_.samples() : 2.0 * trend_.samples();
        while (!reached() && stop < std::max<double>(kMinSamples, trend_.samplesFor(target_.error)))
            stop *= 2.0;
        f.samplesAtTarget = std::max(stop, samples);
        f.remainingSeconds = (f.samplesAtTarget - samples) * perSample;
    }
    if (timeLimit > 0.0) f.errorAtLimit = trend_.errorAt(std::max(samples, timeLimit / perSample));
    return f;
}

}  // namespace rayscope::measure
