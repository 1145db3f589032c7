#include "sampling/sample_stream.h"

#include <cmath>

#include "sampling/hash.h"
#include "sampling/sobol.h"

namespace rayscope::sampling {

PathKey PathKey::child(std::uint32_t branch) const {
    // Not 0, the key of the root.
    return {static_cast<std::uint32_t>(hashPair(value, branch)) | 1u};
}

SampleStream::SampleStream(SamplePattern pattern, std::uint64_t seed, int x, int y, int index,
                           int samplesPerPixel)
    : pattern_(pattern),
      pixelKey_(hashPair(seed, (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32) |
                                   static_cast<std::uint32_t>(x))),
      index_(index),
      samplesPerPixel_(samplesPerPixel) {}

namespace {

/// A pseudo-random permutation of 0 … n − 1: a keyed bijection on the next power of two, iterated until the
/// value is below n (cycle walking).
std::uint32_t permute(std::uint32_t i, std::uint32_t n, std::uint64_t key) {
    std::uint32_t mask = n - 1;
    for (int shift = 1; shift < 32; shift *= 2) mask |= mask >> shift;
    const auto low = static_cast<std::uint32_t>(key), high = static_cast<std::uint32_t>(key >> 32);
    do {
        // Each step is invertible modulo a power of two.
        i = (i ^ low) & mask;
        i = (i * (high | 1u)) & mask;
        i ^= (i & mask) >> 3;
        i = (i + high) & mask;
        i = (i * 0x9e3779b1u) & mask;
        i ^= (i & mask) >> 2;
        i = (i ^ (low >> 7)) & mask;
        i = (i * (low | 1u)) & mask;
    } while (i >= n);
    return i;
}

/// Rows of the grid of exactly n cells that is nearest to a square.
int gridRows(int n) {
    int rows = static_cast<int>(std::sqrt(static_cast<double>(n)));
    while (n % rows != 0) --rows;
    return rows;
}

struct SobolBlock {
    int dimension;
    bool sharesIndex;  ///< with the pixel position: stratified jointly with it
};

/// Pixel, lens, first light at the first hit and time are the coordinates of one seven-dimensional point;
/// everything else is padded with independently shuffled two-dimensional points.
SobolBlock blockOf(Dim dim, PathKey vertex, std::uint32_t which, int n) {
    if (!vertex.isRoot() || which != 0 || n != 1) return {0, false};
    switch (dim) {
        case Dim::Pixel:
            return {0, true};
        case Dim::Lens:
            return {2, true};
        case Dim::Light:
            return {4, true};
        case Dim::Time:
            return {6, true};
        case Dim::Glossy:
            break;
    }
    return {0, false};
}

/// A coordinate of a point of the Sobol sequence, scrambled.
[[gnu::always_inline]] inline float coordinate(std::uint32_t reversedNumber, int dimension,
                                               std::uint32_t seed) {
    return toUnitFloat(reverseBits(owenScrambleReversed(sobolReversed(reversedNumber, dimension), seed)));
}

}  // namespace

SamplePoints SampleStream::points(Dim dim, PathKey vertex, std::uint32_t which, int n) const {
    SamplePoints points;
    points.pattern_ = pattern_;
    const std::uint64_t purpose = (static_cast<std::uint64_t>(dim) << 29) + which;
    points.key_ = derivedKey(pixelKey_, (static_cast<std::uint64_t>(vertex.value) << 32) + purpose);
    points.index_ = index_;
    points.samplesPerPixel_ = samplesPerPixel_;
    points.n_ = n;
    if (pattern_ != SamplePattern::Sobol) return points;
    const SobolBlock block = blockOf(dim, vertex, which, n);
    points.shuffle_ = static_cast<std::uint32_t>(block.sharesIndex ? pixelKey_ : mix(points.key_));
    points.dimension_ = block.dimension;
    return points;
}

glm::vec2 SamplePoints::independent(std::uint64_t key, int k) const {
    const std::uint64_t bits =
        hashPair(key, (static_cast<std::uint64_t>(index_) << 32) | static_cast<std::uint32_t>(k));
    return {toUnitFloat(static_cast<std::uint32_t>(bits)),
            toUnitFloat(static_cast<std::uint32_t>(bits >> 32))};
}

SamplePoints::Stratum SamplePoints::stratum(std::uint64_t key, int k) const {
    if (n_ > 1) return {k, n_};
    const auto index = static_cast<std::uint32_t>(index_ % samplesPerPixel_);
    return {static_cast<int>(permute(index, static_cast<std::uint32_t>(samplesPerPixel_), key)),
            samplesPerPixel_};
}

glm::vec2 SamplePoints::jittered(int k) const {
    const auto [cell, cells] = stratum(key_, k);
    const int rows = gridRows(cells), columns = cells / rows;
    const glm::vec2 offset = independent(key_, k);
    const int column = cell % columns, row = cell / columns;
    const glm::vec2 point((static_cast<float>(column) + offset.x) / static_cast<float>(columns),
                          (static_cast<float>(row) + offset.y) / static_cast<float>(rows));
    return glm::min(point, glm::vec2(1.0f - 0x1p-24f));
}

/// Index of the point in its sequence, shuffled, with its bits reversed. Points of one sample are
/// consecutive.
[[gnu::always_inline]] inline std::uint32_t SamplePoints::shuffled(int k) const {
    const auto number =
        static_cast<std::uint32_t>(index_) * static_cast<std::uint32_t>(n_) + static_cast<std::uint32_t>(k);
    return owenScrambleReversed(reverseBits(number), shuffle_);
}

glm::vec2 SamplePoints::get2D(int k) const {
    if (pattern_ == SamplePattern::Independent) return independent(key_, k);
    if (pattern_ == SamplePattern::Jittered) return jittered(k);
    const std::uint32_t number = shuffled(k);
    return {coordinate(number, dimension_, static_cast<std::uint32_t>(key_)),
            coordinate(number, dimension_ + 1, static_cast<std::uint32_t>(key_ >> 32))};
}

void SampleStream::get2D(Dim dim, std::span<const SampleStream> streams, std::span<glm::vec2> values) {
    SamplePoints points;
    for (std::size_t i = 0; i < streams.size(); ++i) {
        if (i == 0 || streams[i].pixelKey_ != streams[i - 1].pixelKey_) points = streams[i].points(dim);
        points.index_ = streams[i].index_;
        values[i] = points.get2D();
    }
}

float SamplePoints::get1D(int k) const {
    if (pattern_ == SamplePattern::Independent) return independent(key_, k).x;
    if (pattern_ == SamplePattern::Sobol)
        return coordinate(shuffled(k), dimension_, static_cast<std::uint32_t>(key_));
    const std::uint64_t key = mix(key_);  // independent of the numbers of get2D()
    const auto [cell, cells] = stratum(key, k);
    const float x = (static_cast<float>(cell) + independent(key, k).x) / static_cast<float>(cells);
    return x < 1.0f ? x : 1.0f - 0x1p-24f;
}

}  // namespace rayscope::sampling
