#include "measure/target/half_films.h"

#include <algorithm>
#include <cmath>

#include "sampling/hash.h"

namespace rayscope::measure {

int roundUpSampleCount(double x) {
    x = std::clamp(x, 4.0, 1e9);
    const double quarter = std::exp2(std::floor(std::log2(x)) - 2.0);
    return static_cast<int>(std::ceil(x / quarter) * quarter);
}

HalfFilms::HalfFilms(int width, int height, const PixelBounds& region) {
    render::Film::requireMemory(region, films_.size());
    for (auto& film : films_) film = std::make_unique<render::Film>(width, height, region);
    allocation_.assign(static_cast<std::size_t>(films_[0]->tileCount()), 1.0);
}

void HalfFilms::setAllocation(std::vector<double> allocation) { allocation_ = std::move(allocation); }

int HalfFilms::samplesOfTile(std::size_t tile, int samples) const {
    return allocation_[tile] == 1.0 ? samples : roundUpSampleCount(allocation_[tile] * samples);
}

bool HalfFilms::extend(const trace::World& world, std::uint64_t seed, int samples,
                       const std::stop_token& stop, render::RenderCounters& counters) {
    std::vector<int> targets(allocation_.size());
    for (std::size_t tile = 0; tile < targets.size(); ++tile) targets[tile] = samplesOfTile(tile, samples);
    for (std::size_t half = 0; half < films_.size(); ++half)
        if (!render::renderPass(world, half == 0 ? seed : sampling::hashPair(seed, half), *films_[half],
                                targets, {{}, stop}, counters))
            return false;
    return true;
}

template <class SamplesOfTile>
double HalfFilms::perPixel(const SamplesOfTile& samplesOfTile) const {
    double sum = 0.0, pixels = 0.0;
    for (int tile = 0; tile < films_[0]->tileCount(); ++tile) {
        const PixelBounds b = films_[0]->tileBounds(tile);
        const double area = static_cast<double>((b.x1 - b.x0) * (b.y1 - b.y0));
        pixels += area;
        sum += area * samplesOfTile(tile);
    }
    return sum / pixels;
}

double HalfFilms::samplesTaken() const {
    return perPixel([&](int tile) { return 0.0 + films_[0]->samples(tile) + films_[1]->samples(tile); });
}

double HalfFilms::samplesAt(int samples) const {
    return perPixel([&](int tile) { return 2.0 * samplesOfTile(static_cast<std::size_t>(tile), samples); });
}

ErrorEstimate HalfFilms::estimate(const ErrorTarget& target) const {
    const VarianceImage variance = varianceOfMean();
    return estimateError(films_[0]->mean(), films_[1]->mean(), films_[0]->region(), target, &variance);
}

/// From all samples of both halves; the variance of luminance is used for all channels.
VarianceImage HalfFilms::varianceOfMean() const {
    VarianceImage variance(films_[0]->width(), films_[0]->height());
    render::Film::TileCopy copy;
    for (const auto& film : films_) {
        for (int tile = 0; tile < film->tileCount(); ++tile) {
            film->read(tile, copy);
            const double n = copy.samples;
            const PixelBounds bounds = film->tileBounds(tile);
            auto pixel = copy.pixels.begin();
            for (int y = bounds.y0; n > 1.0 && y < bounds.y1; ++y)
                for (int x = bounds.x0; x < bounds.x1; ++x, ++pixel)
                    variance.at(x, y) += render::varianceOfLuminance(*pixel, n) / (4.0 * n);
        }
    }
    return variance;
}

/// Sample counts of the films can differ only in tiles where a limit stopped the second film.
RgbImage HalfFilms::mean() const {
    const render::Film &a = *films_[0], &b = *films_[1];
    RgbImage image = a.mean();
    const RgbImage other = b.mean();
    for (int tile = 0; tile < a.tileCount(); ++tile) {
        const double n = a.samples(tile), m = b.samples(tile);
        const PixelBounds bounds = a.tileBounds(tile);
        for (int y = bounds.y0; n + m > 0.0 && y < bounds.y1; ++y)
            for (int x = bounds.x0; x < bounds.x1; ++x)
                image.at(x, y) =
                    Rgb((n * glm::dvec3(image.at(x, y)) + m * glm::dvec3(other.at(x, y))) / (n + m));
    }
    return image;
}

}  // namespace rayscope::measure
