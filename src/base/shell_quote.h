#pragma once
#include <string>

namespace rayscope::base {

/// A word quoted for a POSIX shell: unchanged if it has no special characters, else in single quotes.
std::string shellQuote(const std::string& word);

}  // namespace rayscope::base
