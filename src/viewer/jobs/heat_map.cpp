#include "viewer/jobs/heat_map.h"

#include <algorithm>
#include <cmath>

#include "viewer/model/viewer_seed.h"

namespace rayscope::viewer {

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
        const double fraction =
            s.highest > s.lowest ? (static_cast<double>(value) - s.lowest) / (s.highest - s.lowest) : 0.0;
        ++s.counts[std::min(static_cast<std::size_t>(fraction * kBins), kBins - 1)];
    }
    return s;
}

RgbImage applyColorMap(const RgbImage& values, ColorMap map, double from, double to) {
    // Colour maps interpolate in Oklab, which is too slow for a million pixels, so the map is tabulated.
    constexpr int kSteps = 1024;
    std::vector<Rgb> table;
    for (int i = 0; i <= kSteps; ++i) table.push_back(mapColor(map, static_cast<double>(i) / kSteps));
    RgbImage image(values.width, values.height);
    for (std::size_t i = 0; i < values.pixels.size(); ++i) {
        const double value = static_cast<double>(values.pixels[i].x);
        const double fraction = to > from ? (value - from) / (to - from) : (value > to ? 1.0 : 0.0);
        image.pixels[i] =
            std::isnan(fraction)
                ? mapColor(map, fraction)
                : table[static_cast<std::size_t>(std::lround(std::clamp(fraction, 0.0, 1.0) * kSteps))];
    }
    return image;
}

HeatMap::Computed HeatMap::compute(const Source& source, int threads, const std::stop_token& stop) {
    const AovRequest request{*source.world, source.film.get(), kViewerSeed, source.samples,
                             std::nullopt,  threads,           stop};
    const Aov aovs[] = {source.aov};
    Computed computed{source, std::move(renderAovs(request, aovs).front()), {}};
    computed.statistics = heatStatistics(computed.values);
    return computed;
}

void HeatMap::update(std::shared_ptr<const trace::World> world, std::shared_ptr<const render::Film> film,
                     int threads) {
    if (auto computed = job_.poll()) {
        values_ = std::move(computed->values);
        world_ = computed->source.world;
        statistics_ = std::move(computed->statistics);
        if (fitRange) {
            from = static_cast<float>(std::min(statistics_.lowest, 0.0));
            to = static_cast<float>(statistics_.upperPercentile);
        }
        recolor();
    }
    if (!shown || !world) return;
    const bool ofFilm = infoOf(aov).isOfFilm();
    const Source wanted{std::move(world), ofFilm ? film : nullptr, aov, samples,
                        ofFilm && film ? samplesOf(*film) : 0};
    if (wanted == requested_) return;
    // A film that has more samples by now is evaluated after the running job: otherwise no job would finish.
    const bool sameImage = wanted.world == requested_.world && wanted.aov == requested_.aov;
    if (job_.busy() && sameImage) return;
    requested_ = wanted;
    job_.start([wanted, threads](const std::stop_token& stop, JobProgress&) {
        return compute(wanted, threads, stop);
    });
}

void HeatMap::recolor() {
    if (!values_) return;
    image_ = applyColorMap(*values_, map, static_cast<double>(from), static_cast<double>(to));
    ++version_;
}

}  // namespace rayscope::viewer
