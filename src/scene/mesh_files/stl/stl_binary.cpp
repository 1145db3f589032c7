#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "scene/mesh_files/stl/stl_facets.h"

namespace rayscope::scene {

namespace {

float floatAt(const char* from) {
    char bytes[sizeof(float)];
    std::memcpy(bytes, from, sizeof bytes);
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes, bytes + sizeof bytes);
    return std::bit_cast<float>(bytes);
}
glm::vec3 vectorAt(const char* from) { return {floatAt(from), floatAt(from + 4), floatAt(from + 8)}; }

}  // namespace

void readBinaryStl(const StlInput& stl, std::uint64_t count) {
    base::BlockReader& input = stl.input;
    const bool namesColors =
        input.peek(kStlHeaderSize).substr(0, 80).find("COLOR=") != std::string_view::npos;
    input.consume(kStlHeaderSize);
    std::uint64_t read = 0;
    bool hasAttributes = namesColors;
    while (read < count) {
        const std::string_view bytes = input.peek(kStlFacetSize);
        const std::size_t some = std::min<std::uint64_t>(count - read, bytes.size() / kStlFacetSize);
        if (some == 0) break;
        for (std::size_t i = 0; i < some; ++i) {
            const char* const facet = bytes.data() + i * kStlFacetSize;
            stl.facets.add(
                {{vectorAt(facet + 12), vectorAt(facet + 24), vectorAt(facet + 36)}, vectorAt(facet)}, 0);
            hasAttributes |= facet[48] != 0 || facet[49] != 0;
        }
        input.consume(some * kStlFacetSize);
        read += some;
        stl.step.advanceTo(input.offset());
    }
    if (hasAttributes)
        stl.oddities.add(Severity::Note,
                         "attributes of facets (colours of VisCAM or Materialise) are ignored");
    if (read < count)
        stl.oddities.add(Severity::Warning,
                         fmt::format("the header announces {} facets, but the file has {}", count, read));
    else if (const std::uint64_t rest = input.size() ? input.remaining() : 0; rest > 0)
        stl.oddities.add(Severity::Warning, fmt::format("{} bytes behind the last facet are ignored", rest));
}

}  // namespace rayscope::scene
