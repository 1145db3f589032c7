#include <rayscope/verdict.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check_argument.h"
#include "image/metrics/check_images.h"
#include "image/srgb.h"
#include "math/vectors.h"

namespace rayscope {

namespace {

constexpr int kMaxNeighbourhood = 15;

void checkRule(const PixelRule& rule) {
    base::checkArgument(rule.tolerance >= 0.0 && std::isfinite(rule.tolerance),
                        "rule: tolerance is {}; expected a number that is at least 0", rule.tolerance);
    base::checkArgument(rule.share >= 0.0 && rule.share <= 1.0, "rule: share is {}; expected 0 … 1",
                        rule.share);
    base::checkArgument(!rule.hardLimit || (*rule.hardLimit >= 0.0 && std::isfinite(*rule.hardLimit)),
                        "rule: hardLimit is {}; expected a number that is at least 0",
                        rule.hardLimit.value_or(0.0));
    base::checkArgument(
        rule.neighbourhood >= 1 && rule.neighbourhood <= kMaxNeighbourhood && rule.neighbourhood % 2 == 1,
        "rule: neighbourhood is {}; expected an odd number from 1 to {}", rule.neighbourhood,
        kMaxNeighbourhood);
}

/// Of display values, whose codes are whole numbers: differences of the codes of 8- and 16-bit files are
/// exact, and so is their comparison with a tolerance such as 4/255.
constexpr double kDisplayScale = 65535.0;

double displayCode(float linear) {
    const float clamped = std::clamp(linear, 0.0f, 1.0f);
    return std::round(static_cast<double>(image::linearToSrgb(clamped)) * kDisplayScale);
}

/// NaN for pixels that are not finite.
Image<glm::dvec3> comparedValues(const RgbImage& image, ComparedValues values) {
    Image<glm::dvec3> result(image.width, image.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Rgb& pixel = image.pixels[i];
        if (!math::isFinite(pixel))
            result.pixels[i] = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
        else if (values == ComparedValues::Linear)
            result.pixels[i] = glm::dvec3(pixel);
        else
            result.pixels[i] = {displayCode(pixel.r), displayCode(pixel.g), displayCode(pixel.b)};
    }
    return result;
}

double sumOf(const glm::dvec3& v) { return v.x + v.y + v.z; }

/// The absolute difference, NaN unless the pixels are finite, of a pixel of `from` to the most similar pixel
/// of `to` within `radius`.
glm::dvec3 leastDifference(const Image<glm::dvec3>& from, const Image<glm::dvec3>& to, int x, int y,
                           int radius) {
    const glm::dvec3 pixel = from.at(x, y);
    glm::dvec3 least = glm::abs(pixel - to.at(x, y));
    for (int ny = std::max(0, y - radius); ny <= std::min(to.height - 1, y + radius); ++ny)
        for (int nx = std::max(0, x - radius); nx <= std::min(to.width - 1, x + radius); ++nx) {
            const glm::dvec3 difference = glm::abs(pixel - to.at(nx, ny));
            if (sumOf(difference) < sumOf(least)) least = difference;
        }
    return least;
}

/// Calls `visit(x, y, difference)` for all pixels, with the absolute difference of the channels, NaN where a
/// pixel is not finite.
template <class Visit>
void forDifferences(const RgbImage& image, const RgbImage& reference, const PixelRule& rule,
                    const Visit& visit) {
    image::checkComparable(image, reference);
    checkRule(rule);
    const Image<glm::dvec3> a = comparedValues(image, rule.values),
                            b = comparedValues(reference, rule.values);
    const double scale = rule.values == ComparedValues::Display ? kDisplayScale : 1.0;
    const int radius = rule.neighbourhood / 2;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const glm::dvec3 there = leastDifference(a, b, x, y, radius),
                             back = radius > 0 ? leastDifference(b, a, x, y, radius) : there;
            visit(x, y, (sumOf(back) > sumOf(there) ? back : there) / scale);
        }
}

double largestOf(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

}  // namespace

double PixelVerdict::score() const { return std::max(0.0, 100.0 - 1000.0 * meanDifference); }

PixelVerdict judgePixels(const RgbImage& image, const RgbImage& reference, const PixelRule& rule) {
    PixelVerdict verdict;
    verdict.pixels = static_cast<long long>(image.pixels.size());
    double sum = 0.0;
    forDifferences(image, reference, rule, [&](int x, int y, const glm::dvec3& difference) {
        if (std::isnan(difference.x)) {
            ++verdict.nonFinite;
            sum += 3.0;
            return;
        }
        const double largest = largestOf(difference);
        sum += sumOf(difference);
        verdict.differing += largest > rule.tolerance;
        verdict.overHardLimit += rule.hardLimit && largest > *rule.hardLimit;
        if (largest > verdict.largest) {
            verdict.largest = largest;
            verdict.largestX = x;
            verdict.largestY = y;
        }
    });
    verdict.differing += verdict.nonFinite;
    if (rule.hardLimit) verdict.overHardLimit += verdict.nonFinite;
    verdict.meanDifference = sum / (3.0 * static_cast<double>(verdict.pixels));
    verdict.passes =
        static_cast<double>(verdict.differing) <= rule.share * static_cast<double>(verdict.pixels) &&
        verdict.overHardLimit == 0;
    return verdict;
}

Image<double> differenceMap(const RgbImage& image, const RgbImage& reference, const PixelRule& rule) {
    Image<double> map(image.width, image.height);
    forDifferences(image, reference, rule,
                   [&](int x, int y, const glm::dvec3& difference) { map.at(x, y) = largestOf(difference); });
    return map;
}

}  // namespace rayscope
