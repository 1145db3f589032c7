#include "base/shell_quote.h"

#include <fmt/format.h>

#include "base/printable_text.h"

namespace rayscope::base {

namespace {

/// $'…' of bash, zsh and POSIX 2024. Three octal digits, because a hexadecimal escape has no fixed length.
std::string quoteWithEscapes(const std::string& word) {
    std::string escaped;
    for (const char c : word) {
        if (c == '\'' || c == '\\')
            escaped += fmt::format("\\{}", c);
        else if (c >= ' ' && c <= '~')
            escaped += c;
        else
            escaped += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
    }
    return "$'" + escaped + "'";
}

}  // namespace

std::string shellQuote(const std::string& word) {
    constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./";
    const bool isPlain = word.find_first_not_of(kPlain) == std::string::npos;
    if (isPlain && !word.empty() && word.front() != '=') return word;
    if (printable(word) != word) return quoteWithEscapes(word);
    std::string escaped;
    for (const char c : word) escaped += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return "'" + escaped + "'";
}

std::string shellQuotePath(const std::string& path) {
    return shellQuote(path.starts_with('-') ? "./" + path : path);
}

}  // namespace rayscope::base
