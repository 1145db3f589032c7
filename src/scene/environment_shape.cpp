#include "scene/environment_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "math/vectors.h"

namespace rayscope::scene {

namespace {

using Cube = std::array<const RgbImage*, 6>;

std::string sizeOf(const RgbImage& image) { return fmt::format("{} x {}", image.width, image.height); }

/// The mean difference between the columns of pixels at the right edge of `left` and the left edge of
/// `right`.
double gapBetween(const RgbImage& left, const RgbImage& right) {
    const int rows = std::min(left.height, right.height);
    double sum = 0.0;
    for (int i = 0; i < rows; ++i) {
        const auto row = [&](const RgbImage& image) {
            return static_cast<int>((i + 0.5) * image.height / rows);
        };
        const Rgb step = left.at(left.width - 1, row(left)) - right.at(0, row(right));
        sum += static_cast<double>(math::luminance(glm::abs(step)));
    }
    return sum / rows;
}

/// Whether the four images at the sides continue each other better with those of +x and −x exchanged. So it
/// is with images made for the left-handed cubes of OpenGL, DirectX, Unity and three.js.
bool joinsExchanged(const Cube& cube) {
    const RgbImage &px = *cube[0], &nx = *cube[1], &pz = *cube[4], &nz = *cube[5];
    const double given = gapBetween(pz, nx) + gapBetween(nx, nz) + gapBetween(nz, px) + gapBetween(px, pz);
    const double other = gapBetween(pz, px) + gapBetween(px, nz) + gapBetween(nz, nx) + gapBetween(nx, pz);
    return other < 0.25 * given;
}

void addCubeOddities(const Cube& cube, std::vector<std::string>& found) {
    std::string oblong, sizes;
    bool differ = false;
    for (std::size_t face = 0; face < cube.size(); ++face) {
        const RgbImage& image = *cube[face];
        const std::string size = fmt::format("{} {}", kCubeFaces[face], sizeOf(image));
        if (image.width != image.height) oblong += (oblong.empty() ? "" : ", ") + size;
        sizes += (sizes.empty() ? "" : ", ") + size;
        differ |= image.width != cube[0]->width || image.height != cube[0]->height;
    }
    if (!oblong.empty())
        found.push_back(fmt::format("the images of a cube should be square; stretched: {} pixels", oblong));
    if (differ) found.push_back(fmt::format("the images of the cube differ in size: {} pixels", sizes));
    if (joinsExchanged(cube))
        found.push_back(
            "the images at the sides do not continue each other, but would with px and nx exchanged; "
            "exchange them if the images were made for OpenGL, DirectX, Unity or three.js");
}

}  // namespace

std::vector<std::string> environmentOddities(const Environment& environment) {
    std::vector<std::string> found;
    if (environment.equirect) {
        const RgbImage& image = environment.equirect->image;
        if (image.width != 2 * image.height)
            found.push_back(
                fmt::format("the image is {} pixels; a latitude-longitude image is twice as wide as "
                            "high; it is stretched to the whole sphere",
                            sizeOf(image)));
        return found;
    }
    Cube cube;
    for (std::size_t face = 0; face < cube.size(); ++face) cube[face] = &environment.cube[face]->image;
    addCubeOddities(cube, found);
    return found;
}

}  // namespace rayscope::scene
