#include "viewer/jobs/heat_map.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "render/film.h"

namespace rayscope::viewer {

namespace {

RgbImage compute(std::shared_ptr<const trace::World> world, std::shared_ptr<const render::Film> film,
                 probe::Aov aov, int samples, int threads, std::stop_token stop) {
    constexpr std::uint64_t kSeed = 0;  // the window renders with this one
    probe::AovRequest request{*world, film.get(), kSeed, samples, std::nullopt, threads, std::move(stop)};
    const probe::Aov wanted[] = {aov};
    return std::move(probe::renderAovs(request, wanted).front());
}

}  // namespace

HeatStatistics heatStatistics(const RgbImage& values) {
    constexpr std::size_t kBins = 64;
    HeatStatistics s;
    std::vector<float> finite;
    for (const Rgb& pixel : values.pixels)
        if (std::isfinite(pixel.x)) finite.push_back(pixel.x);
    s.counts.assign(kBins, 0);
    if (finite.empty()) return s;
    std::sort(finite.begin(), finite.end());
    s.lowest = static_cast<double>(finite.front());
    s.highest = static_cast<double>(finite.back());
    s.upperPercentile = static_cast<double>(finite[(finite.size() - 1) * 99 / 100]);
    for (const float value : finite) {
        s.mean += static_cast<double>(value) / static_cast<double>(finite.size());
        const double share =
            s.highest > s.lowest ? (static_cast<double>(value) - s.lowest) / (s.highest - s.lowest) : 0.0;
        ++s.counts[std::min(static_cast<std::size_t>(share * kBins), kBins - 1)];
    }
    return s;
}

RgbImage applyColorMap(const RgbImage& values, post::ColorMap map, double from, double to) {
    // The path through Oklab is looked up: a picture has a million pixels.
    constexpr int kSteps = 1024;
    std::vector<Rgb> table;
    for (int i = 0; i <= kSteps; ++i) table.push_back(post::mapColor(map, static_cast<double>(i) / kSteps));
    RgbImage image(values.width, values.height);
    for (std::size_t i = 0; i < values.pixels.size(); ++i) {
        const double value = static_cast<double>(values.pixels[i].x);
        const double share = to > from ? (value - from) / (to - from) : (value > to ? 1.0 : 0.0);
        image.pixels[i] =
            std::isnan(share)
                ? post::mapColor(map, share)
                : table[static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * kSteps))];
    }
    return image;
}

void HeatMap::update(std::shared_ptr<const trace::World> world, std::shared_ptr<const render::Film> film,
                     int threads) {
    if (pending_.valid() && pending_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        try {
            values_ = pending_.get();
            computedSource_ = pendingSource_;
            statistics_ = heatStatistics(*values_);
            if (fitRange) {
                from = static_cast<float>(std::min(statistics_.lowest, 0.0));
                to = static_cast<float>(statistics_.upperPercentile);
            }
            recolor();
        } catch (const Stopped&) {
            // Something else is wanted by now.
        }
    }
    if (!shown || !world) return;
    // What the film knows is asked again whenever it has more samples.
    const bool ofFilm = aov >= probe::Aov::Samples;
    const Source wanted{world, ofFilm ? film : nullptr, aov, samples,
                        ofFilm && film ? film->completeSamples() : 0};
    if (wanted == computedSource_) return;
    if (pending_.valid()) {
        if (wanted.world != pendingSource_.world || wanted.aov != pendingSource_.aov) stop_.request_stop();
        return;
    }
    pendingSource_ = wanted;
    stop_ = std::stop_source{};
    pending_ = std::async(std::launch::async, compute, std::move(world), wanted.film, aov, samples, threads,
                          stop_.get_token());
}

void HeatMap::recolor() {
    if (!values_) return;
    image_ = applyColorMap(*values_, map, static_cast<double>(from), static_cast<double>(to));
    ++version_;
}

}  // namespace rayscope::viewer
