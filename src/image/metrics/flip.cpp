// ꟻLIP for low dynamic range. Numbers in comments are sections of the paper (Andersson et al. 2020).
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "image/metrics/perceptual_metrics.h"

namespace rayscope::image {

namespace {

using Color = glm::dvec3;
using ColorPlanes = std::array<Plane, 3>;

constexpr double kPi = std::numbers::pi;
/// CIE XYZ of linear sRGB, as exact fractions, and its white point.
const glm::dmat3 kXyzOfRgb(10135552.0 / 24577794.0, 2613072.0 / 12288897.0, 1425312.0 / 73733382.0,
                           8788810.0 / 24577794.0, 8788810.0 / 12288897.0, 8788810.0 / 73733382.0,
                           4435075.0 / 24577794.0, 887015.0 / 12288897.0, 70074185.0 / 73733382.0);
const Color kWhite(0.950428545, 1.0, 1.088900371);

/// The linearised opponent space YCxCz, in which the contrast sensitivity filters work.
Color opponentOf(const Color& rgb) {
    const Color n = kXyzOfRgb * rgb / kWhite;
    return {116.0 * n.y - 16.0, 500.0 * (n.x - n.y), 200.0 * (n.y - n.z)};
}

Color rgbOfOpponent(const Color& c) {
    static const glm::dmat3 kRgbOfXyz = glm::inverse(kXyzOfRgb);
    const double y = (c.x + 16.0) / 116.0;
    return kRgbOfXyz * (Color(y + c.y / 500.0, y, y - c.z / 200.0) * kWhite);
}

double labCurve(double t) {
    constexpr double kDelta = 6.0 / 29.0;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

/// CIE L*a*b* with chroma scaled by lightness (the Hunt effect).
Color huntLabOf(const Color& rgb) {
    const Color n = kXyzOfRgb * rgb / kWhite;
    const double x = labCurve(n.x), y = labCurve(n.y), z = labCurve(n.z);
    const double lightness = 116.0 * y - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (x - y), 0.01 * lightness * 200.0 * (y - z)};
}

/// The HyAB distance, suited to large colour differences (Abasi et al. 2020).
double hyab(const Color& a, const Color& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

ColorPlanes opponentPlanes(const RgbImage& image) {
    ColorPlanes planes;
    for (Plane& plane : planes) plane = Plane(image.width, image.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Color c = opponentOf(Color(image.pixels[i]));
        for (int k = 0; k < 3; ++k) planes[static_cast<std::size_t>(k)].pixels[i] = c[k];
    }
    return planes;
}

/// Contrast sensitivity of one channel in the spatial domain: a sum of Gaussians a √(π / b) exp(−π² d² / b),
/// d in degrees.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> kSensitivities{
    {{1.0, 0.0047, 0.0, 1e-5}, {1.0, 0.0053, 0.0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};

/// 4.1.1: the channel filtered by the contrast sensitivity at the viewing distance.
Plane filterByContrastSensitivity(const Plane& channel, const Sensitivity& s, double pixelsPerDegree) {
    constexpr double kMaxB = 0.04;  // the widest Gaussian of kSensitivities
    const int radius =
        static_cast<int>(std::ceil(3.0 * std::sqrt(kMaxB / (2.0 * kPi * kPi)) * pixelsPerDegree));
    Plane result(channel.width, channel.height);
    double total = 0.0;
    for (const auto& [a, b] : {std::pair{s.a1, s.b1}, std::pair{s.a2, s.b2}}) {
        if (a == 0.0) continue;
        const double sigma = std::sqrt(b / (2.0 * kPi * kPi)) * pixelsPerDegree;
        const std::vector<double> kernel = gaussianWeights(sigma, radius);
        const double sum = std::accumulate(kernel.begin(), kernel.end(), 0.0);
        const double weight = a * std::sqrt(kPi / b);
        total += weight * sum * sum;
        const Plane part = convolve(channel, kernel, kernel);
        for (std::size_t i = 0; i < result.pixels.size(); ++i) result.pixels[i] += weight * part.pixels[i];
    }
    for (double& value : result.pixels) value /= total;
    return result;
}

std::vector<Color> perceivedColors(const ColorPlanes& planes, double pixelsPerDegree) {
    ColorPlanes filtered;
    for (std::size_t k = 0; k < 3; ++k)
        filtered[k] = filterByContrastSensitivity(planes[k], kSensitivities[k], pixelsPerDegree);
    std::vector<Color> colors;
    for (std::size_t i = 0; i < filtered[0].pixels.size(); ++i) {
        const Color rgb =
            rgbOfOpponent({filtered[0].pixels[i], filtered[1].pixels[i], filtered[2].pixels[i]});
        colors.push_back(huntLabOf(glm::clamp(rgb, 0.0, 1.0)));
    }
    return colors;
}

constexpr double kColorExponent = 0.7;

/// 4.1.3: maps the colour difference to 0 … 1; the lower 40 % of the range takes 95 % of the output.
double redistribute(double difference) {
    static const double kMaxDifference =
        std::pow(hyab(huntLabOf({0.0, 1.0, 0.0}), huntLabOf({0.0, 0.0, 1.0})), kColorExponent);
    constexpr double kBend = 0.4, kAtBend = 0.95;
    const double d = std::pow(difference, kColorExponent), bend = kBend * kMaxDifference;
    if (d < bend) return kAtBend / bend * d;
    return kAtBend + (d - bend) / (kMaxDifference - bend) * (1.0 - kAtBend);
}

/// Scales the positive weights to a sum of 1 and the negative ones to −1.
void normalizeBySign(std::vector<double>& kernel) {
    double positive = 0.0, negative = 0.0;
    for (const double w : kernel) (w > 0.0 ? positive : negative) += std::abs(w);
    for (double& w : kernel) w /= w > 0.0 ? positive : negative;
}

/// A Gaussian of the width of a just visible feature, and its first and second derivatives.
struct FeatureKernels {
    explicit FeatureKernels(double pixelsPerDegree) {
        const double sigma = 0.5 * 0.082 * pixelsPerDegree;
        const int radius = static_cast<int>(std::ceil(3.0 * sigma));
        smooth = gaussianWeights(sigma, radius);
        for (int x = -radius; x <= radius; ++x) {
            const double g = smooth[static_cast<std::size_t>(x + radius)];
            edge.push_back(-x * g);
            point.push_back((x * x / (sigma * sigma) - 1.0) * g);
        }
        const double sum = std::accumulate(smooth.begin(), smooth.end(), 0.0);
        for (double& w : smooth) w /= sum;
        normalizeBySign(edge);
        normalizeBySign(point);
    }
    std::vector<double> smooth, edge, point;
};

/// 4.2: the magnitude of the edge (or point) detector at each pixel.
Plane featureStrength(const Plane& y, const std::vector<double>& kernel, const std::vector<double>& smooth) {
    Plane alongX = convolve(y, kernel, smooth);
    const Plane alongY = convolve(y, smooth, kernel);
    for (std::size_t i = 0; i < alongX.pixels.size(); ++i)
        alongX.pixels[i] = std::hypot(alongX.pixels[i], alongY.pixels[i]);
    return alongX;
}

}  // namespace

Plane flipMap(const RgbImage& image, const RgbImage& reference, double pixelsPerDegree) {
    ColorPlanes a = opponentPlanes(image), b = opponentPlanes(reference);
    const std::vector<Color> colorsA = perceivedColors(a, pixelsPerDegree);
    const std::vector<Color> colorsB = perceivedColors(b, pixelsPerDegree);
    const FeatureKernels kernels(pixelsPerDegree);
    for (Plane* y : {&a[0], &b[0]})
        for (double& value : y->pixels) value = (value + 16.0) / 116.0;
    const Plane edgeA = featureStrength(a[0], kernels.edge, kernels.smooth);
    const Plane edgeB = featureStrength(b[0], kernels.edge, kernels.smooth);
    const Plane pointA = featureStrength(a[0], kernels.point, kernels.smooth);
    const Plane pointB = featureStrength(b[0], kernels.point, kernels.smooth);

    Plane flip(image.width, image.height);
    for (std::size_t i = 0; i < flip.pixels.size(); ++i) {
        const double color = redistribute(hyab(colorsA[i], colorsB[i]));
        const double feature = std::max(std::abs(edgeA.pixels[i] - edgeB.pixels[i]),
                                        std::abs(pointA.pixels[i] - pointB.pixels[i]));
        flip.pixels[i] = std::pow(color, 1.0 - std::sqrt(std::min(1.0, feature / std::numbers::sqrt2)));
    }
    return flip;
}

}  // namespace rayscope::image
