#include <rayscope/compare.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/srgb.h"

namespace rayscope {

namespace {

/// Green's cube helix: a spiral around the grey diagonal of the colour cube from black to white, with
/// lightness proportional to `f`, so that the order of values is kept in greyscale. Start, turns and hue are
/// the paper's.
Rgb cubeHelix(double f) {
    constexpr double kStart = 0.5, kTurns = -1.5, kHue = 1.0;
    const double angle = 2.0 * std::numbers::pi * (kStart / 3.0 + 1.0 + kTurns * f);
    const double amplitude = kHue * f * (1.0 - f) / 2.0;
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dvec3 encoded(f + amplitude * (-0.14861 * c + 1.78277 * s),
                             f + amplitude * (-0.29227 * c - 0.90649 * s), f + amplitude * 1.97294 * c);
    Rgb linear;
    for (int k = 0; k < 3; ++k)
        linear[k] = image::srgbToLinear(static_cast<float>(std::clamp(encoded[k], 0.0, 1.0)));
    return linear;
}

}  // namespace

RgbImage applyColorMap(const Image<double>& map, double range) {
    RgbImage image(map.width, map.height);
    const double scale = range > 0.0 ? 1.0 / range : 0.0;
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        const double value = map.pixels[i];
        image.pixels[i] =
            std::isfinite(value) ? cubeHelix(std::clamp(value * scale, 0.0, 1.0)) : Rgb(1.0f, 0.0f, 1.0f);
    }
    return image;
}

}  // namespace rayscope
