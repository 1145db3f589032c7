#pragma once
#include <string>

namespace rayscope::base {

/// A word quoted for a shell: unchanged if it has no special characters, else in single quotes, or in $'…' if
/// it holds control characters or bytes that are not UTF-8, which a terminal or a report would not show.
std::string shellQuote(const std::string& word);

/// shellQuote() of a path, with "./" before a leading dash, which would begin an option.
std::string shellQuotePath(const std::string& path);

}  // namespace rayscope::base
