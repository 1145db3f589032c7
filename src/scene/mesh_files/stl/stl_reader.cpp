#include "scene/mesh_files/stl/stl_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "base/little_endian.h"
#include "scene/mesh_files/stl/stl_facets.h"
#include "scene/mesh_files/text/foreign_format.h"

namespace rayscope::scene {

namespace {

constexpr std::string_view kMark = "\xef\xbb\xbf";  // of UTF-8

bool isTextCharacter(char c) {
    const auto code = static_cast<unsigned char>(c);
    return code >= ' ' || (code >= '\t' && code <= '\r') || code == 0x1a;
}

/// Skips blanks and, without case, the word; false if another one follows.
bool skipWord(std::string_view& text, std::string_view word) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n\v\f"), text.size());
    text.remove_prefix(begin);
    for (std::size_t i = 0; i < word.size(); ++i)
        if (i >= text.size() || (text[i] | 0x20) != word[i]) return false;
    text.remove_prefix(word.size());
    return true;
}

/// Whether the file starts as ASCII files do: "solid", a name up to the end of the line, "facet" or
/// "endsolid". Programs also write "solid" into the header of binary files.
bool startsAsAscii(std::string_view start) {
    if (start.starts_with(kMark)) start.remove_prefix(kMark.size());
    if (!skipWord(start, "solid")) return false;
    const std::size_t end = start.find_first_of("\r\n");
    const std::string_view name = start.substr(0, end);
    if (!std::all_of(name.begin(), name.end(), isTextCharacter)) return false;
    if (end == std::string_view::npos) return true;
    start.remove_prefix(end);
    std::string_view other = start;
    const bool isEmpty = start.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos;
    return isEmpty || skipWord(start, "facet") || skipWord(other, "endsolid") ||
           std::all_of(start.begin(), start.end(), isTextCharacter);
}

/// Whether the first facets of a binary file have coordinates as they occur, and not arbitrary bytes.
bool hasPlausibleFacets(std::string_view start) {
    constexpr float kLargest = 1e36f;
    constexpr std::size_t kMost = 100;
    if (start.size() < kStlHeaderSize + kStlFacetSize) return false;
    start.remove_prefix(kStlHeaderSize);
    const std::size_t count = std::min(kMost, start.size() / kStlFacetSize);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 12; ++k)
            if (!(std::abs(std::bit_cast<float>(base::littleEndian32(start, i * kStlFacetSize + 4 * k))) <
                  kLargest))
                return false;
    return true;
}

struct StlKind {
    bool isBinary = false;
    std::uint64_t count = 0;  ///< of facets in a binary file, as announced
};

/// Decides by the size of the file, then by its first bytes.
StlKind detect(const std::string& path, base::BlockReader& input, Oddities& oddities) {
    const std::string_view start = input.peek(kStlHeaderSize + 100 * kStlFacetSize);
    const std::optional<std::uint64_t> size = input.size();
    const std::uint64_t count = start.size() >= kStlHeaderSize ? base::littleEndian32(start, 80) : 0;
    const bool isExact = start.size() >= kStlHeaderSize && size == kStlHeaderSize + kStlFacetSize * count;
    if (isExact && count > 0) return {true, count};
    if (startsAsAscii(start)) return {};
    const std::string_view beginning = start.substr(0, 512);
    const bool isText = std::all_of(beginning.begin(), beginning.end(), isTextCharacter);
    const bool isForeign = isText || !foreignFormat(start, "STL").empty();
    if (isExact && !isForeign) throw InputError("the file has no facets", {path});
    if (isForeign || !hasPlausibleFacets(start))
        throw InputError(
            describeForeign(start, "STL", "neither begins with the word 'solid' nor holds binary facets"),
            {path});
    if (count > 0 || !size) return {true, count};
    // Some programs leave the count at 0 because they do not know it when they write the header.
    const std::uint64_t fitting = (*size - kStlHeaderSize) / kStlFacetSize;
    oddities.add(Severity::Warning,
                 fmt::format("the header announces 0 facets, but the file has {}", fitting));
    return {true, fitting};
}

std::uint64_t expectedFacets(const StlKind& kind, const base::BlockReader& input) {
    constexpr std::uint64_t kBytesPerAsciiFacet = 200;
    if (!input.size()) return 0;
    if (!kind.isBinary) return *input.size() / kBytesPerAsciiFacet;
    return std::min(kind.count, (*input.size() - kStlHeaderSize) / kStlFacetSize);
}

}  // namespace

ImportedMesh readStl(const std::string& path, const ImportContext& context) {
    base::BlockReader input(path);
    LoadStep step(context.control, fmt::format("reading {}", std::filesystem::path(path).filename().string()),
                  static_cast<std::size_t>(input.size().value_or(0)));
    Oddities oddities(path);
    const StlKind kind = detect(path, input, oddities);
    StlFacets facets(expectedFacets(kind, input), oddities);
    const StlInput stl{path, input, facets, oddities, step};
    if (kind.isBinary) {
        readBinaryStl(stl, kind.count);
    } else {
        if (input.peek(kMark.size()).starts_with(kMark)) input.consume(kMark.size());
        readAsciiStl(stl);
    }
    auto data = std::make_shared<const MeshData>(facets.finish(path));
    oddities.report(context.notes);
    return {std::move(data), {Material{.name = "default"}}};
}

}  // namespace rayscope::scene
