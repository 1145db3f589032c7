#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/generate/generate.h"

namespace rayscope::scene {

RgbImage generateSky(int width, int height) {
    const glm::dvec3 sun = glm::normalize(glm::dvec3(-0.6, 0.55, -0.5));
    const glm::dvec3 zenith(0.10, 0.24, 0.62), horizon(0.62, 0.74, 0.88), ground(0.17, 0.14, 0.11);
    RgbImage image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double elevation = std::numbers::pi * (0.5 - (y + 0.5) / height);
            const double azimuth = 2.0 * std::numbers::pi * ((x + 0.5) / width - 0.5);
            const glm::dvec3 direction(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                                       -std::cos(elevation) * std::cos(azimuth));
            glm::dvec3 color = glm::mix(horizon, zenith, std::pow(std::max(direction.y, 0.0), 0.55));
            // Haze over a few degrees instead of a sharp horizon.
            color = glm::mix(color, ground, glm::smoothstep(0.02, -0.06, direction.y));
            const double toSun = glm::dot(direction, sun);
            color += glm::dvec3(1.0, 0.85, 0.6) * 0.35 * std::pow(std::max(toSun, 0.0), 60.0);
            color += glm::dvec3(1.0, 0.95, 0.85) * 8.0 * glm::smoothstep(0.9985, 0.9993, toSun);
            image.at(x, y) = color;
        }
    return image;
}

}  // namespace rayscope::scene
