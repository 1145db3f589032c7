#include "render/film.h"

#include <algorithm>
#include <limits>

#include "base/memory_budget.h"

namespace rayscope::render {

namespace {
int tilesAcross(int pixels) { return (pixels + Film::kTileSize - 1) / Film::kTileSize; }
int areaOf(const PixelBounds& b) { return (b.x1 - b.x0) * (b.y1 - b.y0); }
}  // namespace

Film::Film(int width, int height, PixelBounds region)
    : width_(width), height_(height), region_(region), columns_(tilesAcross(region.x1 - region.x0)) {
    requireMemory(region, 1);
    const int rows = tilesAcross(region.y1 - region.y0);
    for (int i = 0; i < columns_ * rows; ++i) tiles_.push_back(std::make_unique<Tile>());
}

void Film::requireMemory(const PixelBounds& region, std::uint64_t films, std::uint64_t images) {
    const int width = region.x1 - region.x0, height = region.y1 - region.y0;
    const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    base::requireMemory(pixels * (films * sizeof(PixelSums) + images * sizeof(Rgb)), "a smaller --size",
                        "a film of {} x {} pixels", width, height);
}

PixelBounds Film::tileBounds(int tile) const {
    const int x0 = region_.x0 + tile % columns_ * kTileSize, y0 = region_.y0 + tile / columns_ * kTileSize;
    return {x0, std::min(x0 + kTileSize, region_.x1), y0, std::min(y0 + kTileSize, region_.y1)};
}

void Film::read(int tile, TileCopy& copy) const {
    const Tile& from = *tiles_[static_cast<std::size_t>(tile)];
    const std::scoped_lock guard(from.lock);
    if (from.pixels.empty())
        copy.pixels.assign(static_cast<std::size_t>(areaOf(tileBounds(tile))), PixelSums{});
    else
        copy.pixels = from.pixels;
    copy.samples = from.samples;
    copy.version = from.version;
}

void Film::commit(int tile, TileCopy&& copy) {
    Tile& to = *tiles_[static_cast<std::size_t>(tile)];
    const std::scoped_lock guard(to.lock);
    to.pixels.swap(copy.pixels);
    to.samples = copy.samples;
    ++to.version;
}

std::uint32_t Film::version(int tile) const { return tiles_[static_cast<std::size_t>(tile)]->version; }

int Film::samples(int tile) const {
    const Tile& from = *tiles_[static_cast<std::size_t>(tile)];
    const std::scoped_lock guard(from.lock);
    return from.samples;
}

int Film::completeSamples() const {
    int least = std::numeric_limits<int>::max();
    for (int i = 0; i < tileCount(); ++i) least = std::min(least, samples(i));
    return tiles_.empty() ? 0 : least;
}

int Film::mostSamples() const {
    int most = 0;
    for (int i = 0; i < tileCount(); ++i) most = std::max(most, samples(i));
    return most;
}

double Film::doneFraction(int targetSamples) const {
    double sum = 0.0;
    for (int i = 0; i < tileCount(); ++i) sum += std::min(samples(i), targetSamples);
    return tiles_.empty() ? 1.0 : sum / (static_cast<double>(tileCount()) * targetSamples);
}

int Film::tileAt(int x, int y) const {
    return (y - region_.y0) / kTileSize * columns_ + (x - region_.x0) / kTileSize;
}

PixelSums Film::sums(int x, int y, int& samples) const {
    const int tile = tileAt(x, y);
    const PixelBounds bounds = tileBounds(tile);
    const Tile& from = *tiles_[static_cast<std::size_t>(tile)];
    const std::scoped_lock guard(from.lock);
    samples = from.samples;
    if (from.pixels.empty()) return {};
    return from.pixels[static_cast<std::size_t>((y - bounds.y0) * (bounds.x1 - bounds.x0) + x - bounds.x0)];
}

RgbImage Film::mean() const {
    int least = 0, most = 0;
    return mean(least, most);
}

RgbImage Film::mean(int& leastSamples, int& mostSamples) const {
    leastSamples = tiles_.empty() ? 0 : std::numeric_limits<int>::max();
    mostSamples = 0;
    RgbImage image(width_, height_, Rgb(0.0f));
    for (int tile = 0; tile < tileCount(); ++tile) {
        const Tile& from = *tiles_[static_cast<std::size_t>(tile)];
        const std::scoped_lock guard(from.lock);
        leastSamples = std::min(leastSamples, from.samples);
        mostSamples = std::max(mostSamples, from.samples);
        if (from.samples == 0) continue;
        const PixelBounds bounds = tileBounds(tile);
        const PixelSums* pixel = from.pixels.data();
        for (int y = bounds.y0; y < bounds.y1; ++y)
            for (int x = bounds.x0; x < bounds.x1; ++x)
                image.at(x, y) = Rgb((pixel++)->radiance / static_cast<double>(from.samples));
    }
    return image;
}

}  // namespace rayscope::render
