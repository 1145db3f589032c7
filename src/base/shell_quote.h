#pragma once
#include <string>

namespace rayscope::base {

/// A word as a POSIX shell reads it back: as it is where nothing in it is special, else in single quotes.
std::string shellQuote(const std::string& word);

}  // namespace rayscope::base
