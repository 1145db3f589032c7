#include <numeric>

#include "image/metrics/perceptual_metrics.h"
#include "image/srgb.h"
#include "math/vectors.h"

namespace rayscope::image {

namespace {

Plane encodedLuminance(const RgbImage& image) {
    Plane plane(image.width, image.height);
    for (std::size_t i = 0; i < plane.pixels.size(); ++i) {
        const Rgb& c = image.pixels[i];
        plane.pixels[i] = static_cast<double>(linearToSrgb(math::luminance(c)));
    }
    return plane;
}

Plane product(const Plane& a, const Plane& b) {
    Plane result(a.width, a.height);
    for (std::size_t i = 0; i < a.pixels.size(); ++i) result.pixels[i] = a.pixels[i] * b.pixels[i];
    return result;
}

}  // namespace

Plane ssimMap(const RgbImage& image, const RgbImage& reference) {
    std::vector<double> window = gaussianWeights(1.5, 5);
    const double sum = std::accumulate(window.begin(), window.end(), 0.0);
    for (double& weight : window) weight /= sum;
    const auto mean = [&](const Plane& plane) { return convolve(plane, window, window); };

    const Plane a = encodedLuminance(image), b = encodedLuminance(reference);
    const Plane meanA = mean(a), meanB = mean(b);
    const Plane squareA = mean(product(a, a)), squareB = mean(product(b, b)), cross = mean(product(a, b));
    constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;
    Plane ssim(a.width, a.height);
    for (std::size_t i = 0; i < ssim.pixels.size(); ++i) {
        const double ma = meanA.pixels[i], mb = meanB.pixels[i];
        const double varianceA = squareA.pixels[i] - ma * ma, varianceB = squareB.pixels[i] - mb * mb;
        const double covariance = cross.pixels[i] - ma * mb;
        ssim.pixels[i] = (2.0 * ma * mb + kC1) * (2.0 * covariance + kC2) /
                         ((ma * ma + mb * mb + kC1) * (varianceA + varianceB + kC2));
    }
    return ssim;
}

}  // namespace rayscope::image
