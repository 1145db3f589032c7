#pragma once
// Environment maps made from functions of the direction.
#include <rayscope/scene.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace rayscope::test {

/// A cube map whose texels hold f(unit direction): the pictures of a viewer inside the cube who looks along
/// +x −x +y −y +z −z with these directions upwards.
template <class F>
std::shared_ptr<const Environment> cubeOf(int size, F&& f) {
    auto environment = std::make_shared<Environment>();
    const glm::dvec3 forward[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const glm::dvec3 upward[6] = {{0, 1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}};
    for (int face = 0; face < 6; ++face) {
        const glm::dvec3 right = glm::cross(forward[face], upward[face]);
        auto texture = std::make_shared<Texture>();
        texture->image = RgbImage(size, size);
        for (int j = 0; j < size; ++j)
            for (int i = 0; i < size; ++i) {
                const double s = 2.0 * (i + 0.5) / size - 1.0, t = 2.0 * (j + 0.5) / size - 1.0;
                texture->image.at(i, j) = f(glm::normalize(forward[face] + s * right - t * upward[face]));
            }
        environment->cube[static_cast<std::size_t>(face)] = texture;
    }
    return environment;
}

/// A latitude-longitude map: the top row looks up, the middle looks along −z, the right of it along +x.
template <class F>
std::shared_ptr<const Environment> equirectOf(int width, int height, F&& f) {
    auto texture = std::make_shared<Texture>();
    texture->image = RgbImage(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const double longitude = 2.0 * std::numbers::pi * ((i + 0.5) / width - 0.5);
            const double latitude = std::numbers::pi * (0.5 - (j + 0.5) / height);
            texture->image.at(i, j) =
                f(glm::dvec3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                             -std::cos(latitude) * std::cos(longitude)));
        }
    auto environment = std::make_shared<Environment>();
    environment->equirect = texture;
    return environment;
}

}  // namespace rayscope::test
