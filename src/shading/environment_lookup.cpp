#include "shading/environment_lookup.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rayscope::shading {

namespace {

/// Axes of a face as seen in its image, and outwards; right = down × out, for a viewer inside.
struct FaceAxes {
    glm::dvec3 right, down, out;
};
const FaceAxes kFaces[6] = {{{0, 0, 1}, {0, -1, 0}, {1, 0, 0}},  {{0, 0, -1}, {0, -1, 0}, {-1, 0, 0}},
                            {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},  {{-1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                            {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};

glm::dvec3 texel(const RgbImage& image, int x, int y) {
    return glm::dvec3(image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1)));
}

/// The texel at (x, y) of a face; beyond an edge, the texel of the neighbouring face at that position.
glm::dvec3 cubeTexel(const Environment& environment, int face, int x, int y) {
    const RgbImage* image = &environment.cube[static_cast<std::size_t>(face)]->image;
    if (x >= 0 && y >= 0 && x < image->width && y < image->height) return texel(*image, x, y);
    const double s = (x + 0.5) / image->width, t = (y + 0.5) / image->height;
    const CubePoint beyond = cubePoint(cubeDirection(face, s, t));
    image = &environment.cube[static_cast<std::size_t>(beyond.face)]->image;
    return texel(*image, static_cast<int>(beyond.s * image->width),
                 static_cast<int>(beyond.t * image->height));
}

glm::dvec3 lookupCube(const Environment& environment, const glm::dvec3& direction) {
    const CubePoint point = cubePoint(direction);
    const RgbImage& image = environment.cube[static_cast<std::size_t>(point.face)]->image;
    const double x = point.s * image.width - 0.5, y = point.t * image.height - 0.5;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const auto mixed = [&](int j) {
        return glm::mix(cubeTexel(environment, point.face, column, j),
                        cubeTexel(environment, point.face, column + 1, j), x - column);
    };
    return glm::mix(mixed(row), mixed(row + 1), y - row);
}

glm::dvec3 lookupEquirect(const RgbImage& image, const glm::dvec3& d) {
    // The centre of the image is −z; the top row is +y.
    const double longitude = std::atan2(d.x, -d.z), latitude = std::atan2(d.y, std::hypot(d.x, d.z));
    const double x = (longitude / (2.0 * std::numbers::pi) + 0.5) * image.width - 0.5;
    const double y = (0.5 - latitude / std::numbers::pi) * image.height - 0.5;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const auto at = [&](int i, int j) {
        // Over a pole the image continues on the opposite meridian.
        if (j < 0 || j >= image.height) {
            j = j < 0 ? 0 : image.height - 1;
            i += image.width / 2;
        }
        return texel(image, ((i % image.width) + image.width) % image.width, j);
    };
    const auto mixed = [&](int j) { return glm::mix(at(column, j), at(column + 1, j), x - column); };
    return glm::mix(mixed(row), mixed(row + 1), y - row);
}

bool isUsable(const glm::dvec3& d) {
    return std::isfinite(d.x) && std::isfinite(d.y) && std::isfinite(d.z) && d != glm::dvec3(0.0);
}

}  // namespace

CubePoint cubePoint(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    int axis = 2;
    if (size.x >= size.y && size.x >= size.z)
        axis = 0;
    else if (size.y >= size.z)
        axis = 1;
    const int face = 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
    const FaceAxes& axes = kFaces[face];
    const double scale = 0.5 / size[axis];
    return {face, std::clamp(0.5 + scale * glm::dot(direction, axes.right), 0.0, 1.0),
            std::clamp(0.5 + scale * glm::dot(direction, axes.down), 0.0, 1.0)};
}

glm::dvec3 cubeDirection(int face, double s, double t) {
    const FaceAxes& axes = kFaces[face];
    return axes.out + (2.0 * s - 1.0) * axes.right + (2.0 * t - 1.0) * axes.down;
}

glm::dvec3 lookup(const Environment& environment, const glm::dvec3& direction) {
    const glm::dvec3 d = isUsable(direction) ? direction : glm::dvec3(0.0, 0.0, 1.0);
    return environment.equirect ? lookupEquirect(environment.equirect->image, d) : lookupCube(environment, d);
}

}  // namespace rayscope::shading
