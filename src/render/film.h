#pragma once
#include <rayscope/image.h>
#include <rayscope/render_session.h>
#include <rayscope/vector.h>
#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "math/vectors.h"

namespace rayscope::render {

/// Sums over the samples 0 … n − 1 of a pixel, in this order.
struct PixelSums {
    RgbSum radiance{0.0};
    double squaredLuminance = 0.0;
};

/// The sample variance of the luminance of n ≥ 2 samples.
inline double varianceOfLuminance(const PixelSums& sums, double n) {
    const double mean = math::luminance(sums.radiance) / n;
    return std::max(0.0, sums.squaredLuminance / n - mean * mean) * n / (n - 1.0);
}

/// Sums of all pixels, in square tiles. A tile is replaced as a whole, so that at any time it holds the left
/// fold over the first `samples` samples of each of its pixels. All functions may be called from any thread.
class Film {
  public:
    static constexpr int kTileSize = 32;

    /// Throws OutOfMemory unless there is memory for all tiles, which is allocated as they are committed.
    Film(int width, int height, PixelBounds region);
    /// Throws OutOfMemory unless there is memory for so many films of a region and, beside them, for images
    /// of its size.
    static void requireMemory(const PixelBounds& region, std::uint64_t films, std::uint64_t images = 0);

    int width() const { return width_; }
    int height() const { return height_; }
    const PixelBounds& region() const { return region_; }

    int tileCount() const { return static_cast<int>(tiles_.size()); }
    PixelBounds tileBounds(int tile) const;  ///< clipped to the region
    int tileAt(int x, int y) const;          ///< the tile of a pixel of the region

    /// A consistent copy of a tile.
    struct TileCopy {
        std::vector<PixelSums> pixels;  ///< row by row within tileBounds()
        int samples = 0;
        std::uint32_t version = 0;  ///< grows with each commit
    };
    void read(int tile, TileCopy& copy) const;
    void commit(int tile, TileCopy&& copy);  ///< the pixels of `copy` are unspecified afterwards
    std::uint32_t version(int tile) const;
    int samples(int tile) const;

    /// The smallest and the largest number of samples that a tile has.
    int completeSamples() const;
    int mostSamples() const;
    /// The fraction, 0 … 1, of `targetSamples` in all tiles that are committed.
    double doneFraction(int targetSamples) const;
    /// Sums and sample count of one pixel of the region.
    PixelSums sums(int x, int y, int& samples) const;

    /// The mean of each pixel; outside the region, and before the first sample, 0.
    RgbImage mean() const;
    /// The same with the smallest and the largest number of samples of these means.
    RgbImage mean(int& leastSamples, int& mostSamples) const;

  private:
    struct Tile {
        mutable std::mutex lock;
        std::vector<PixelSums> pixels;  ///< empty until the first commit
        int samples = 0;
        std::atomic<std::uint32_t> version{0};
    };

    int width_, height_;
    PixelBounds region_;
    int columns_;
    std::vector<std::unique_ptr<Tile>> tiles_;
};

}  // namespace rayscope::render
