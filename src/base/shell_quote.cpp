#include "base/shell_quote.h"

namespace rayscope::base {

std::string shellQuote(const std::string& word) {
    constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string escaped;
    for (const char c : word) escaped += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return "'" + escaped + "'";
}

}  // namespace rayscope::base
