// File format: a header line in text; for each tile of the part, in the order of the film, its pixel sums and
// a checksum over everything before. Numbers are in the byte order of the machine: the bits of an image are
// those of one build of the program, too.
#include "measure/parts/film_part.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include <cstring>
#include <fstream>
#include <sstream>

#include "base/atomic_file.h"
#include "render/image_metadata.h"
#include "sampling/hash.h"

namespace rayscope::measure {

namespace {

constexpr int kMostParts = 1 << 20, kMostPartSamples = 1 << 30;
constexpr std::size_t kLongestPartHeader = 1024;

std::string partHeaderText(const FilmPartHeader& h) {
    return fmt::format("rayscope part 1 {} {} {} {} {} {} {} {} {} {} {} {}\n", h.contentHash, h.seed,
                       h.samples, h.width, h.height, h.region.x0, h.region.x1, h.region.y0, h.region.y1,
                       h.part, h.parts, render::softwareName());
}

std::uint64_t extendChecksum(std::uint64_t sum, const void* data, std::size_t size) {
    const auto* const bytes = static_cast<const char*>(data);
    sum = sampling::hashPair(sum, size);
    for (std::size_t i = 0; i < size; i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes + i, std::min<std::size_t>(8, size - i));
        sum = sampling::hashPair(sum, word);
    }
    return sum;
}

bool isPlausible(const FilmPartHeader& h) {
    const PixelBounds& r = h.region;
    return h.samples > 0 && h.samples <= kMostPartSamples && h.parts > 0 && h.parts <= kMostParts &&
           h.part > 0 && h.part <= h.parts && 0 <= r.x0 && r.x0 < r.x1 && r.x1 <= h.width && 0 <= r.y0 &&
           r.y0 < r.y1 && r.y1 <= h.height;
}

FilmPartHeader takePartHeader(std::istream& file, const std::string& path) {
    std::string line(kLongestPartHeader, '\0');
    file.getline(line.data(), static_cast<std::streamsize>(line.size()));
    if (!file) throw InputError("is not a part of an image, or cannot be read", {path});
    line.resize(std::strlen(line.c_str()));
    std::istringstream words(line);
    std::string program, kind, format;
    FilmPartHeader h;
    words >> program >> kind >> format;
    if (program != "rayscope" || kind != "part") throw InputError("is not a part of an image", {path});
    words >> h.contentHash >> h.seed >> h.samples >> h.width >> h.height >> h.region.x0 >> h.region.x1 >>
        h.region.y0 >> h.region.y1 >> h.part >> h.parts;
    if (format == "1" && (!words || !isPlausible(h))) throw InputError("is damaged in its header", {path});
    if (line + '\n' != partHeaderText(h))
        throw InputError("was written by another version of the program; render it again", {path});
    return h;
}

/// What differs between a part and the image that it is merged into, or "".
std::string differenceOf(const FilmPartHeader& a, const FilmPartHeader& b) {
    const auto numbers = [](std::string_view what, auto is, auto expected) {
        return fmt::format("has {} {}, not {}", what, is, expected);
    };
    if (a.seed != b.seed) return numbers("seed", a.seed, b.seed);
    if (a.samples != b.samples) return numbers("samples per pixel:", a.samples, b.samples);
    if (a.width != b.width || a.height != b.height)
        return fmt::format("is of {} x {} pixels, not {} x {}", a.width, a.height, b.width, b.height);
    if (!(a.region == b.region)) return "has other --pixelbounds than the first part";
    if (a.parts != b.parts) return numbers("a share of", a.parts, b.parts);
    if (a.contentHash != b.contentHash) return "was rendered from another scene, camera or settings";
    return {};
}

bool areSame(const std::vector<render::PixelSums>& a, const std::vector<render::PixelSums>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

}  // namespace

void saveFilmPart(const std::string& path, const FilmPartHeader& header, const render::Film& film) {
    base::AtomicFile file(path);
    const std::string text = partHeaderText(header);
    file.write(text);
    std::uint64_t sum = extendChecksum(0, text.data(), text.size());
    render::Film::TileCopy copy;
    for (int tile = header.part - 1; tile < film.tileCount(); tile += header.parts) {
        film.read(tile, copy);
        const std::size_t size = copy.pixels.size() * sizeof copy.pixels[0];
        sum = extendChecksum(sum, copy.pixels.data(), size);
        file.write({reinterpret_cast<const char*>(copy.pixels.data()), size});
        file.write({reinterpret_cast<const char*>(&sum), sizeof sum});
    }
    file.commit();
}

FilmPartHeader readFilmPartHeader(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return takePartHeader(file, path);
}

void FilmPartMerger::add(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const FilmPartHeader header = takePartHeader(file, path);
    if (const std::string difference = differenceOf(header, expected_); !difference.empty())
        throw InputError("does not belong to this image: it " + difference, {path});
    const std::string text = partHeaderText(header);
    std::uint64_t sum = extendChecksum(0, text.data(), text.size());
    render::Film::TileCopy before, copy;
    for (int tile = header.part - 1; tile < film_.tileCount(); tile += header.parts) {
        film_.read(tile, before);
        copy = before;
        const std::size_t size = copy.pixels.size() * sizeof copy.pixels[0];
        std::uint64_t stored = 0;
        file.read(reinterpret_cast<char*>(copy.pixels.data()), static_cast<std::streamsize>(size));
        file.read(reinterpret_cast<char*>(&stored), sizeof stored);
        if (!file) throw InputError("is incomplete; render this part again", {path});
        sum = extendChecksum(sum, copy.pixels.data(), size);
        if (sum != stored) throw InputError("is damaged; render this part again", {path});
        if (before.samples > 0 && !areSame(before.pixels, copy.pixels))
            throw InputError(fmt::format("differs from another file of part {}", header.part), {path});
        copy.samples = header.samples;
        film_.commit(tile, std::move(copy));
    }
    if (file.peek() != std::ifstream::traits_type::eof())
        throw InputError("has more bytes than its tiles; render this part again", {path});
    added_[static_cast<std::size_t>(header.part - 1)] = true;
}

std::vector<int> FilmPartMerger::missing() const {
    std::vector<int> parts;
    for (std::size_t i = 0; i < added_.size(); ++i)
        if (!added_[i]) parts.push_back(static_cast<int>(i) + 1);
    return parts;
}

}  // namespace rayscope::measure
