#include "measure/target/sample_allocation.h"

#include "math/vectors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rayscope::measure {

namespace {

double variancePerPixel(const render::Film& pilot, int tile, bool relative) {
    render::Film::TileCopy copy;
    pilot.read(tile, copy);
    const double n = copy.samples;
    double sum = 0.0;
    for (const render::PixelSums& pixel : copy.pixels) {
        const double mean = math::luminance(pixel.radiance) / n;
        double variance = render::varianceOfLuminance(pixel, n);
        if (relative) variance /= mean * mean + 0.01;
        if (std::isfinite(variance)) sum += variance;
    }
    return sum / static_cast<double>(copy.pixels.size());
}

bool touch(const PixelBounds& a, const PixelBounds& b) {
    return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

void scaleToMeanOne(std::vector<double>& allocation) {
    const double mean =
        std::accumulate(allocation.begin(), allocation.end(), 0.0) / static_cast<double>(allocation.size());
    for (double& samples : allocation) samples = mean > 0.0 ? samples / mean : 1.0;
}

}  // namespace

std::vector<double> allocateSamples(const render::Film& pilot, bool relative, bool equalErrors) {
    std::vector<double> allocation;
    for (int tile = 0; tile < pilot.tileCount(); ++tile) {
        const double variance = variancePerPixel(pilot, tile, relative);
        allocation.push_back(equalErrors ? variance : std::sqrt(variance));
    }
    scaleToMeanOne(allocation);
    std::vector<double> widened = allocation;
    for (int tile = 0; tile < pilot.tileCount(); ++tile) {
        double& samples = widened[static_cast<std::size_t>(tile)];
        samples = std::max(samples, 0.25);
        for (int other = 0; other < pilot.tileCount(); ++other)
            if (touch(pilot.tileBounds(tile), pilot.tileBounds(other)))
                samples = std::max(samples, 0.5 * allocation[static_cast<std::size_t>(other)]);
    }
    scaleToMeanOne(widened);
    return widened;
}

}  // namespace rayscope::measure
