// File format: a header line with content hash, size and version of the program; for each tile of each film
// its sample count and pixel sums; a checksum. Numbers are in the byte order of the machine, since the file
// is a local cache.
#include "measure/trade/film_file.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "base/private_file.h"
#include "math/vectors.h"
#include "render/image_metadata.h"
#include "sampling/hash.h"

namespace rayscope::measure {

namespace {

constexpr int kMostSamples = 1 << 20;  // per pixel

std::string headerOf(const std::string& hash, const render::Film& film) {
    return fmt::format("rayscope films 2 {} {} {} {}\n", hash, film.width(), film.height(),
                       render::softwareName());
}

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
    bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

template <class T>
void take(std::string_view& bytes, T* values, std::size_t count) {
    std::memcpy(values, bytes.data(), count * sizeof(T));
    bytes.remove_prefix(count * sizeof(T));
}

std::size_t bytesOf(const render::Film& film) {
    std::size_t bytes = 0;
    for (int tile = 0; tile < film.tileCount(); ++tile) {
        const PixelBounds b = film.tileBounds(tile);
        bytes +=
            sizeof(int) + sizeof(render::PixelSums) * static_cast<std::size_t>((b.x1 - b.x0) * (b.y1 - b.y0));
    }
    return bytes;
}

/// Whether n samples can have these sums; the mean of their squares is at least the square of their mean.
bool isPossible(const render::PixelSums& sums, int n) {
    constexpr double kRounding = 1e-9;  // of sums over 2^20 samples
    const double luminance = math::luminance(sums.radiance);
    if (!math::isFinite(sums.radiance) || !std::isfinite(sums.squaredLuminance)) return false;
    if (n == 0) return sums.radiance == RgbSum(0.0) && sums.squaredLuminance == 0.0;
    return luminance * luminance <= n * sums.squaredLuminance * (1.0 + kRounding) + 1e-300;
}

/// Why a tile cannot be the result of rendering, or "".
std::string problemOf(const render::Film::TileCopy& copy) {
    if (copy.samples < 0 || copy.samples > kMostSamples)
        return fmt::format("{} samples per pixel", copy.samples);
    for (const render::PixelSums& sums : copy.pixels)
        if (!isPossible(sums, copy.samples)) return "impossible pixel values";
    return {};
}

/// The tiles of a film, and the bytes after them.
std::vector<render::Film::TileCopy> takeTiles(std::string_view& bytes, const render::Film& film) {
    std::vector<render::Film::TileCopy> tiles(static_cast<std::size_t>(film.tileCount()));
    for (int i = 0; i < film.tileCount(); ++i) {
        render::Film::TileCopy& copy = tiles[static_cast<std::size_t>(i)];
        film.read(i, copy);  // for its size
        take(bytes, &copy.samples, 1);
        take(bytes, copy.pixels.data(), copy.pixels.size());
    }
    return tiles;
}

void fill(render::Film& film, std::vector<render::Film::TileCopy>&& tiles) {
    for (std::size_t i = 0; i < tiles.size(); ++i) film.commit(static_cast<int>(i), std::move(tiles[i]));
}

/// The file without header and checksum. Throws InputError if one of them is wrong.
std::string_view contentOf(std::string_view file, const std::string& header, std::size_t size,
                           const std::string& path) {
    std::uint64_t sum = 0;
    if (!file.starts_with(header)) throw InputError("was written for another scene or version", {path});
    if (file.size() != header.size() + size + sizeof sum) throw InputError("is incomplete", {path});
    std::memcpy(&sum, file.data() + file.size() - sizeof sum, sizeof sum);
    file.remove_suffix(sizeof sum);
    if (sum != filmFileChecksum(file)) throw InputError("is damaged", {path});
    return file.substr(header.size());
}

}  // namespace

std::uint64_t filmFileChecksum(std::string_view bytes) {
    std::uint64_t sum = bytes.size();
    for (std::size_t i = 0; i < bytes.size(); i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
        sum = sampling::hashPair(sum, word);
    }
    return sum;
}

void saveFilms(const std::string& path, const std::string& hash, const render::Film& a,
               const render::Film& b) {
    std::string bytes = headerOf(hash, a);
    render::Film::TileCopy copy;
    for (const render::Film* film : {&a, &b}) {
        for (int tile = 0; tile < film->tileCount(); ++tile) {
            film->read(tile, copy);
            if (const std::string problem = problemOf(copy); !problem.empty())
                throw InputError("cannot be saved: " + problem, {path});
            append(bytes, &copy.samples, 1);
            append(bytes, copy.pixels.data(), copy.pixels.size());
        }
    }
    const std::uint64_t sum = filmFileChecksum(bytes);
    append(bytes, &sum, 1);
    base::writePrivateFile(path, bytes);
}

bool loadFilms(const std::string& path, const std::string& hash, render::Film& a, render::Film& b) {
    const std::string header = headerOf(hash, a);
    const std::size_t size = bytesOf(a) + bytesOf(b);
    const auto file = base::readPrivateFile(path, header.size() + size + sizeof(std::uint64_t));
    if (!file) return false;
    std::string_view bytes = contentOf(*file, header, size, path);
    std::vector<render::Film::TileCopy> ofA = takeTiles(bytes, a), ofB = takeTiles(bytes, b);
    for (const auto* tiles : {&ofA, &ofB})
        for (const render::Film::TileCopy& tile : *tiles)
            if (const std::string problem = problemOf(tile); !problem.empty())
                throw InputError("is not a film: " + problem, {path});
    fill(a, std::move(ofA));
    fill(b, std::move(ofB));
    return true;
}

}  // namespace rayscope::measure
