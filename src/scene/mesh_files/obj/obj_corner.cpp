#include "scene/mesh_files/obj/obj_corner.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace rayscope::scene {

namespace {

bool parseIndex(const char*& at, const char* end, std::int64_t& value) {
    const bool isNegative = at != end && *at == '-';
    if (at != end && (*at == '-' || *at == '+')) ++at;
    if (at == end || *at < '0' || *at > '9') return false;
    // Larger ones are out of range in any case; sums with the number of elements do not overflow.
    constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max() / 4;
    std::int64_t sum = 0;
    for (; at != end && *at >= '0' && *at <= '9'; ++at)
        sum = sum > (kLargest - 9) / 10 ? kLargest : sum * 10 + (*at - '0');
    value = isNegative ? -sum : sum;
    return true;
}

/// An index that may be left out, behind a slash.
bool parseOptionalIndex(const char*& at, const char* end, std::optional<std::int64_t>& value) {
    if (at == end || *at == '/') return true;
    std::int64_t index = 0;
    if (!parseIndex(at, end, index)) return false;
    value = index;
    return true;
}

}  // namespace

bool parseCorner(std::string_view word, WrittenCorner& corner) {
    const char* at = word.data();
    const char* const end = at + word.size();
    corner.texCoord.reset();
    corner.normal.reset();
    if (!parseIndex(at, end, corner.position)) return false;
    for (auto* const index : {&corner.texCoord, &corner.normal}) {
        if (at == end) return true;
        if (*at++ != '/' || !parseOptionalIndex(at, end, *index)) return false;
    }
    return at == end;
}

std::string cornerError(std::string_view word) {
    const auto has = [&](char c) { return word.find(c) != std::string_view::npos; };
    std::string_view hint;
    if (std::count(word.begin(), word.end(), '/') > 2)
        hint = "; a corner has at most a position, a texture coordinate and a normal";
    else if (has(','))
        hint = "; indices have no commas";
    else if (has('.'))
        hint = "; indices are whole numbers";
    else if (word.front() == '/')
        hint = "; a corner starts with the index of its position";
    return fmt::format("expected an index, got '{}'{}", word, hint);
}

}  // namespace rayscope::scene
