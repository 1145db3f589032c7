#include "base/printable_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::base {

namespace {

/// The first character of a text: how many bytes it takes, and its code point unless they are not UTF-8.
struct Character {
    std::size_t bytes = 1;
    bool isValid = false;
    char32_t code = 0;
};

Character firstOf(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return {1, true, first};
    const std::size_t count = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < count) return {};
    char32_t code = first & (0xFFu >> (count + 1));
    for (std::size_t i = 1; i < count; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {};
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    constexpr char32_t kLowest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool isSurrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < kLowest[count] || code > 0x10FFFF || isSurrogate) return {};
    return {count, true, code};
}

/// Whether a terminal acts on it instead of showing it, or shows text in another order because of it.
bool isHidden(char32_t code) {
    return code < 0x20 || (code >= 0x7F && code <= 0x9F) || code == 0x200E || code == 0x200F ||
           (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

/// Copies the text and passes what cannot be shown as it is to escape(character, bytes).
template <class Escape>
std::string withEscapes(std::string_view text, Escape&& escape) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const Character next = firstOf(text);
        const std::string_view bytes = text.substr(0, next.bytes);
        if (next.isValid && !isHidden(next.code))
            result += bytes;
        else
            result += escape(next, bytes);
        text.remove_prefix(next.bytes);
    }
    return result;
}

std::string escapeOf(const Character& character, std::string_view bytes) {
    if (character.isValid && character.code == '\n') return "\\n";
    if (character.isValid && character.code == '\r') return "\\r";
    if (character.isValid && character.code == '\t') return "\\t";
    if (character.isValid && character.code >= 0x80)
        return fmt::format("\\u{{{:04X}}}", static_cast<unsigned>(character.code));
    return fmt::format("\\x{:02X}", static_cast<unsigned char>(bytes[0]));
}

/// The largest position up to `at` where a character begins.
std::size_t characterBegin(std::string_view text, std::size_t at) {
    while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) --at;
    return at;
}

}  // namespace

std::string printable(std::string_view text) { return withEscapes(text, escapeOf); }

std::string printableLines(std::string_view text) {
    return withEscapes(text, [](const Character& character, std::string_view bytes) {
        return character.isValid && character.code == '\n' ? "\n" : escapeOf(character, bytes);
    });
}

std::string shortened(std::string text, std::size_t most) {
    constexpr std::string_view kGap = " … ";
    if (text.size() <= most) return text;
    const std::size_t kept = most - std::min(most, kGap.size());
    const std::size_t head = characterBegin(text, kept - kept / 3);
    const std::size_t tail = characterBegin(text, text.size() - kept / 3);
    return text.substr(0, head).append(kGap).append(text.substr(tail));
}

std::string quoted(std::string_view text, std::size_t most) {
    // Escapes take up to 8 times the space: what is cut off anyway need not be escaped.
    const std::string cut = shortened(std::string(text), 2 * most);
    return "'" + shortened(printable(cut), most) + "'";
}

std::string validUtf8(std::string_view text) {
    return withEscapes(text, [](const Character& character, std::string_view bytes) {
        const bool isBlank = character.isValid && (character.code == '\n' || character.code == '\t');
        return isBlank ? std::string(bytes) : std::string("\uFFFD");
    });
}

std::string printableJson(std::string_view json) {
    return withEscapes(json, [](const Character& character, std::string_view bytes) {
        // Below 0x20 are only the line feeds between the tokens.
        if (character.code < 0x20) return std::string(bytes);
        return fmt::format("\\u{:04x}", static_cast<unsigned>(character.code));
    });
}

}  // namespace rayscope::base
