#include "post/bloom.h"

#include <rayscope/diagnostics.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/vectors.h"

namespace rayscope::post {

namespace {

/// Integral of a normal density of standard deviation sigma over [i − 1/2, i + 1/2].
double gaussianOverPixel(int i, double sigma) {
    const double scale = 1.0 / (sigma * std::numbers::sqrt2);
    return 0.5 * (std::erf((i + 0.5) * scale) - std::erf((i - 0.5) * scale));
}

/// Convolves along x and transposes, so that calling it twice convolves along both axes.
RgbImage convolveRowsAndTranspose(const RgbImage& image, const std::vector<double>& kernel,
                                  const std::stop_token& stop) {
    constexpr int kPixelsPerCheck = 1024;
    const int radius = static_cast<int>(kernel.size() / 2);
    RgbImage result(image.height, image.width);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (x % kPixelsPerCheck == 0 && stop.stop_requested()) throw Stopped();
            RgbSum sum(0.0);
            const int from = std::max(-radius, -x), to = std::min(radius, image.width - 1 - x);
            for (int i = from; i <= to; ++i)
                sum += kernel[static_cast<std::size_t>(i + radius)] * RgbSum(image.at(x + i, y));
            result.at(y, x) = Rgb(sum);
        }
    }
    return result;
}

}  // namespace

std::vector<double> bloomKernel(BloomFilter filter, int radius, double sigma) {
    std::vector<double> kernel(static_cast<std::size_t>(2 * radius + 1), 0.0);
    double sum = 0.0;
    for (int i = -radius; i <= radius; ++i) {
        double weight = 1.0;
        if (filter == BloomFilter::Gaussian)
            weight = sigma > 0.0 ? gaussianOverPixel(i, sigma) : (i == 0 ? 1.0 : 0.0);
        kernel[static_cast<std::size_t>(i + radius)] = weight;
        sum += weight;
    }
    for (double& weight : kernel) weight /= sum;
    return kernel;
}

RgbImage bloomThresholded(const RgbImage& image, float threshold) {
    RgbImage bright = image;
    for (Rgb& pixel : bright.pixels)
        if (!math::isFinite(pixel) || !(std::max({pixel.x, pixel.y, pixel.z}) > threshold)) pixel = Rgb(0.0f);
    return bright;
}

RgbImage bloomFiltered(const RgbImage& image, const std::vector<double>& kernel,
                       const std::stop_token& stop) {
    return convolveRowsAndTranspose(convolveRowsAndTranspose(image, kernel, stop), kernel, stop);
}

RgbImage applyBloom(const RgbImage& image, const Settings& settings, const std::stop_token& stop) {
    if (!settings.bloom) return image;
    RgbImage glow = bloomThresholded(image, settings.bloomThreshold);
    if (settings.bloomDebug && settings.bloomStage == BloomStage::Thresholded) return glow;
    glow = bloomFiltered(
        glow, bloomKernel(settings.bloomFilter, settings.bloomSize, static_cast<double>(settings.bloomSigma)),
        stop);
    for (Rgb& pixel : glow.pixels) pixel *= settings.bloomScale;
    if (settings.bloomDebug && settings.bloomStage == BloomStage::Filtered) return glow;
    for (std::size_t i = 0; i < glow.pixels.size(); ++i) glow.pixels[i] += image.pixels[i];
    return glow;
}

}  // namespace rayscope::post
