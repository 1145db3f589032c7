#pragma once
#include <string>
#include <string_view>

namespace rayscope::base {

/// The text with the letters A … Z replaced by a … z.
inline std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

}  // namespace rayscope::base
