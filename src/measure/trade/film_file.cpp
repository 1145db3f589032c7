// File format: a header line with content hash and size; for each tile of each film its sample count and
// pixel sums; a checksum. Numbers are in the byte order of the machine, since the file is a local cache.
#include "measure/trade/film_file.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include <cstring>
#include <filesystem>

#include "base/atomic_file.h"
#include "base/read_file.h"
#include "sampling/hash.h"

namespace rayscope::measure {

namespace {

std::string headerOf(const std::string& hash, const render::Film& film) {
    return fmt::format("rayscope films 1 {} {} {}\n", hash, film.width(), film.height());
}

std::uint64_t checksum(std::string_view bytes) {
    std::uint64_t sum = bytes.size();
    for (std::size_t i = 0; i < bytes.size(); i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
        sum = sampling::hashPair(sum, word);
    }
    return sum;
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

void takeFilm(std::string_view& bytes, render::Film& film) {
    render::Film::TileCopy copy;
    for (int tile = 0; tile < film.tileCount(); ++tile) {
        film.read(tile, copy);
        take(bytes, &copy.samples, 1);
        take(bytes, copy.pixels.data(), copy.pixels.size());
        film.commit(tile, std::move(copy));
    }
}

}  // namespace

void saveFilms(const std::string& path, const std::string& hash, const render::Film& a,
               const render::Film& b) {
    std::string bytes = headerOf(hash, a);
    render::Film::TileCopy copy;
    for (const render::Film* film : {&a, &b}) {
        for (int tile = 0; tile < film->tileCount(); ++tile) {
            film->read(tile, copy);
            append(bytes, &copy.samples, 1);
            append(bytes, copy.pixels.data(), copy.pixels.size());
        }
    }
    const std::uint64_t sum = checksum(bytes);
    append(bytes, &sum, 1);
    std::error_code ignored;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path(), ignored);
    base::writeFileAtomically(path, bytes);
}

bool loadFilms(const std::string& path, const std::string& hash, render::Film& a, render::Film& b) {
    std::string file;
    try {
        file = base::readFile(path);
    } catch (const InputError&) {
        return false;
    }
    const std::string header = headerOf(hash, a);
    std::uint64_t sum = 0;
    if (file.size() != header.size() + bytesOf(a) + bytesOf(b) + sizeof sum || !file.starts_with(header))
        return false;
    std::string_view bytes(file);
    std::memcpy(&sum, bytes.data() + bytes.size() - sizeof sum, sizeof sum);
    if (sum != checksum(bytes.substr(0, bytes.size() - sizeof sum))) return false;
    bytes.remove_prefix(header.size());
    takeFilm(bytes, a);
    takeFilm(bytes, b);
    return true;
}

}  // namespace rayscope::measure
