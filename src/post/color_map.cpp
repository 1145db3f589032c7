#include <rayscope/display.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rayscope {

namespace {

/// Lightness 0 … 1 and two opponent axes: a from green to red, b from blue to yellow.
struct Oklab {
    double lightness, a, b;
};

glm::dvec3 toLinearRgb(const Oklab& color) {
    const double l = color.lightness + 0.3963377774 * color.a + 0.2158037573 * color.b;
    const double m = color.lightness - 0.1055613458 * color.a - 0.0638541728 * color.b;
    const double s = color.lightness - 0.0894841775 * color.a - 1.2914855480 * color.b;
    const double l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
    return {4.0767416621 * l3 - 3.3077115913 * m3 + 0.2309699292 * s3,
            -1.2684380046 * l3 + 2.6097574011 * m3 - 0.3413193965 * s3,
            -0.0041960863 * l3 - 0.7034186147 * m3 + 1.7076147010 * s3};
}

bool inGamut(const glm::dvec3& c) {
    return glm::all(glm::greaterThanEqual(c, glm::dvec3(0.0))) &&
           glm::all(glm::lessThanEqual(c, glm::dvec3(1.0)));
}

/// Reduces chroma, at constant lightness, until the colour is in the sRGB gamut; by bisection, so that the
/// map stays smooth.
Rgb fitToGamut(const Oklab& color) {
    const auto withChroma = [&](double kept) {
        return toLinearRgb({color.lightness, kept * color.a, kept * color.b});
    };
    double kept = 0.0, step = 1.0;
    for (int i = 0; i < 40; ++i, step *= 0.5)
        if (kept + step <= 1.0 && inGamut(withChroma(kept + step))) kept += step;
    return Rgb(glm::clamp(withChroma(kept), 0.0, 1.0));
}

}  // namespace

Rgb mapColor(ColorMap map, double value) {
    if (std::isnan(value)) return {1.0f, 0.0f, 1.0f};
    const double x = std::clamp(value, 0.0, 1.0);
    const double lightness = 0.22 + 0.70 * x;
    switch (map) {
        case ColorMap::Spectrum: {
            // From violet (310°) through blue and green to yellow (108°).
            const double hue = (310.0 - 202.0 * x) * std::numbers::pi / 180.0;
            return fitToGamut({lightness, 0.15 * std::cos(hue), 0.15 * std::sin(hue)});
        }
        case ColorMap::BlueGold:
            return fitToGamut({lightness, 0.0, 0.13 * (2.0 * x - 1.0)});
        case ColorMap::Grey:
            break;
    }
    return fitToGamut({lightness, 0.0, 0.0});
}

}  // namespace rayscope
