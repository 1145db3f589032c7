#pragma once
#include <algorithm>
#include <string_view>

namespace rayscope::base {

/// Whether the path ends in the suffix, which is in lower case, e.g. ".obj"; the case of the path does not
/// matter.
inline bool hasSuffix(std::string_view path, std::string_view suffix) {
    if (path.size() < suffix.size()) return false;
    return std::equal(suffix.rbegin(), suffix.rend(), path.rbegin(), [](char a, char b) {
        return a == (b >= 'A' && b <= 'Z' ? static_cast<char>(b - 'A' + 'a') : b);
    });
}

}  // namespace rayscope::base
