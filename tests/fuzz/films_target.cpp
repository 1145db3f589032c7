#include <rayscope/diagnostics.h>

#include "fuzz/memory_file.h"
#include "measure/trade/film_file.h"

namespace rayscope::test {

namespace {

const std::string kHash = "hash";

/// Two films of the size that is expected.
struct Films {
    static constexpr PixelBounds kWhole{0, 4, 0, 3};
    render::Film a{4, 3, kWhole}, b{4, 3, kWhole};
};

std::string saved(const Films& films) {
    static const MemoryFile file("saved");
    measure::saveFilms(file.path(), kHash, films.a, films.b);
    return readText(file.path());
}

std::span<const std::byte> bytesOf(const std::string& text) { return std::as_bytes(std::span(text)); }

/// Whether the file is accepted, which only what saveFilms() can write may be.
bool isAccepted(FuzzInput input) {
    static const MemoryFile file("films");
    Films films;
    bool isLoaded = false;
    try {
        isLoaded = measure::loadFilms(file.write(input), kHash, films.a, films.b);
    } catch (const InputError&) {
    }
    if (isLoaded)
        require(saved(films) == textOf(input), "accepted films are saved as they were read");
    else
        require(films.a.completeSamples() == 0 && films.b.completeSamples() == 0, "refused films stay empty");
    return isLoaded;
}

}  // namespace

/// Any bytes fill two films of the expected size, or none, or are refused with the reason. They are tried as
/// a file, and as the tiles between a header and the checksum of what they become.
bool fuzzFilms(FuzzInput input) {
    static const std::string header = [] {
        const std::string empty = saved({});
        return empty.substr(0, empty.find('\n') + 1);
    }();
    isAccepted(input);
    std::string file = header + std::string(textOf(input));
    const std::uint64_t sum = measure::filmFileChecksum(file);
    file.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    isAccepted(bytesOf(file));
    return true;
}

}  // namespace rayscope::test
