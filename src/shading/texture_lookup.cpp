#include "shading/texture_lookup.h"

#include <algorithm>
#include <cmath>

namespace rayscope::shading {

namespace {

/// Wraps a coordinate into [0, 1], so that an index computed from it fits an int.
double wrapUnit(double x, TextureWrap wrap) {
    if (!std::isfinite(x)) return 0.0;
    return wrap == TextureWrap::Repeat ? x - std::floor(x) : std::clamp(x, 0.0, 1.0);
}

int wrapIndex(int i, int size, TextureWrap wrap) {
    if (wrap == TextureWrap::Clamp) return std::clamp(i, 0, size - 1);
    return ((i % size) + size) % size;
}

/// Length of the intersection of the pixel [i, i + 1) with [from, to).
double overlap(double from, double to, int i) { return std::min(to, i + 1.0) - std::max(from, 1.0 * i); }

/// Box filter over the exact area of each new pixel, so that odd sizes also keep the mean of the image.
RgbImage halved(const RgbImage& image, const std::stop_token& stop) {
    RgbImage half(std::max(1, image.width / 2), std::max(1, image.height / 2));
    const double columns = static_cast<double>(image.width) / half.width;
    const double rows = static_cast<double>(image.height) / half.height;
    for (int y = 0; y < half.height; ++y) {
        if (stop.stop_requested()) throw Stopped();
        for (int x = 0; x < half.width; ++x) {
            const double x0 = x * columns, x1 = x0 + columns, y0 = y * rows, y1 = y0 + rows;
            RgbSum sum(0.0);
            for (int j = static_cast<int>(y0); j < std::min(static_cast<int>(std::ceil(y1)), image.height);
                 ++j)
                for (int i = static_cast<int>(x0); i < std::min(static_cast<int>(std::ceil(x1)), image.width);
                     ++i)
                    sum += overlap(x0, x1, i) * overlap(y0, y1, j) * RgbSum(image.at(i, j));
            half.at(x, y) = Rgb(sum / (columns * rows));
        }
    }
    return half;
}

}  // namespace

BilinearTap bilinearTap(int width, int height, const glm::dvec2& uv, TextureWrap wrap) {
    // Texel centres are at half-integers; row 0 is the top of the image, v = 0 the bottom.
    const double x = wrapUnit(uv.x, wrap) * width - 0.5;
    const double y = (1.0 - wrapUnit(uv.y, wrap)) * height - 0.5;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    return {{wrapIndex(column, width, wrap), wrapIndex(column + 1, width, wrap)},
            {wrapIndex(row, height, wrap), wrapIndex(row + 1, height, wrap)},
            x - column,
            y - row};
}

MipTexture::MipTexture(std::shared_ptr<const Texture> texture, bool withLevels, const std::stop_token& stop)
    : texture_(std::move(texture)) {
    if (!withLevels) return;
    while (level(levels_.size()).width > 1 || level(levels_.size()).height > 1)
        levels_.push_back(halved(level(levels_.size()), stop));
}

glm::dvec3 MipTexture::nearest(const glm::dvec2& uv) const {
    const RgbImage& image = texture_->image;
    const double u = wrapUnit(uv.x, texture_->wrap), v = wrapUnit(uv.y, texture_->wrap);
    const int x = std::min(static_cast<int>(u * image.width), image.width - 1);
    const int y = std::min(static_cast<int>((1.0 - v) * image.height), image.height - 1);
    return glm::dvec3(image.at(x, y));
}

glm::dvec3 MipTexture::bilinear(const RgbImage& image, const glm::dvec2& uv) const {
    const BilinearTap tap = bilinearTap(image.width, image.height, uv, texture_->wrap);
    const auto row = [&](int y) {
        return glm::mix(glm::dvec3(image.at(tap.x[0], y)), glm::dvec3(image.at(tap.x[1], y)), tap.weightX);
    };
    return glm::mix(row(tap.y[0]), row(tap.y[1]), tap.weightY);
}

/// Interpolates between the two levels whose texels are nearest in size to the footprint (Williams 1983,
/// "Pyramidal Parametrics").
glm::dvec3 MipTexture::trilinear(const glm::dvec2& uv, double footprint) const {
    const double texels = footprint * std::max(width(), height());
    const double highest = static_cast<double>(levels_.size());
    const double lambda = std::clamp(texels > 1.0 ? std::log2(texels) : 0.0, 0.0, highest);
    const auto fine = static_cast<std::size_t>(lambda);
    const glm::dvec3 color = bilinear(level(fine), uv);
    if (fine == levels_.size()) return color;
    return glm::mix(color, bilinear(level(fine + 1), uv), lambda - static_cast<double>(fine));
}

glm::dvec3 MipTexture::lookup(const glm::vec2& uv, double footprint, TextureFilter filter) const {
    switch (filter) {
        case TextureFilter::Nearest:
            return nearest(glm::dvec2(uv));
        case TextureFilter::Bilinear:
            return bilinear(texture_->image, glm::dvec2(uv));
        case TextureFilter::Mipmap:
            break;
    }
    return trilinear(glm::dvec2(uv), footprint);
}

}  // namespace rayscope::shading
