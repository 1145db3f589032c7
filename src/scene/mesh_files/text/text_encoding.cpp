#include "scene/mesh_files/text/text_encoding.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace rayscope::scene {

namespace {

constexpr char32_t kReplacement = 0xfffd;

void append(std::string& text, char32_t code) {
    const auto put = [&](char32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xc0 | code >> 6);
        put(0x80 | (code & 0x3f));
    } else if (code < 0x10000) {
        put(0xe0 | code >> 12);
        put(0x80 | (code >> 6 & 0x3f));
        put(0x80 | (code & 0x3f));
    } else {
        put(0xf0 | code >> 18);
        put(0x80 | (code >> 12 & 0x3f));
        put(0x80 | (code >> 6 & 0x3f));
        put(0x80 | (code & 0x3f));
    }
}

/// Of the ASCII bytes from `at` on.
std::size_t asciiLength(std::string_view bytes, std::size_t at) {
    const std::size_t begin = at;
    for (std::uint64_t block; at + sizeof block <= bytes.size(); at += sizeof block) {
        std::memcpy(&block, bytes.data() + at, sizeof block);
        if (block & 0x8080808080808080u) break;
    }
    while (at < bytes.size() && static_cast<unsigned char>(bytes[at]) < 0x80) ++at;
    return at - begin;
}

/// The length of the sequence of UTF-8 at `at`; 0 if it is invalid: truncated, overlong, a surrogate or
/// beyond U+10FFFF.
std::size_t sequenceLength(std::string_view bytes, std::size_t at) {
    const auto byte = [&](std::size_t i) -> unsigned {
        return at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u;
    };
    const unsigned lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
    for (std::size_t i = 1; i < length; ++i)
        if (byte(i) < 0x80 || byte(i) > 0xbf) return 0;
    const bool isOverlong = (lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xf0 && byte(1) < 0x90);
    const bool isOutside = (lead == 0xed && byte(1) > 0x9f) || (lead == 0xf4 && byte(1) > 0x8f);
    return isOverlong || isOutside ? 0 : length;
}

/// Code points of the bytes 0x80 … 0x9f; undefined ones stay control characters.
constexpr std::array<char16_t, 32> kWindows1252{
    0x20ac, 0x81,   0x201a, 0x192,  0x201e, 0x2026, 0x2020, 0x2021, 0x2c6,  0x2030, 0x160,
    0x2039, 0x152,  0x8d,   0x17d,  0x8f,   0x90,   0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
    0x2013, 0x2014, 0x2dc,  0x2122, 0x161,  0x203a, 0x153,  0x9d,   0x17e,  0x178};

/// The code point of the valid sequence of `length` bytes at `at`.
char32_t codeAt(std::string_view bytes, std::size_t at, std::size_t length) {
    const auto byte = [&](std::size_t i) { return char32_t(static_cast<unsigned char>(bytes[at + i])); };
    if (length == 1) return byte(0);
    char32_t code = byte(0) & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) code = code << 6 | (byte(i) & 0x3f);
    return code;
}

}  // namespace

bool isUtf32(std::string_view bytes) {
    using namespace std::string_view_literals;
    if (bytes.starts_with("\xff\xfe\0\0"sv) || bytes.starts_with("\0\0\xfe\xff"sv)) return true;
    const std::size_t groups = std::min<std::size_t>(bytes.size(), 64) / 4;
    if (groups < 2) return false;
    std::size_t zeros[4] = {0, 0, 0, 0};
    for (std::size_t i = 0; i < 4 * groups; ++i) zeros[i % 4] += bytes[i] == '\0';
    const bool hasMiddle = zeros[1] == groups && zeros[2] == groups;
    return hasMiddle && ((zeros[0] == 0 && zeros[3] == groups) || (zeros[0] == groups && zeros[3] == 0));
}

std::optional<ByteOrder> utf16Order(std::string_view bytes) {
    if (bytes.starts_with("\xff\xfe")) return ByteOrder::Little;
    if (bytes.starts_with("\xfe\xff")) return ByteOrder::Big;
    const std::size_t pairs = std::min<std::size_t>(bytes.size(), 64) / 2;
    if (pairs < 4) return {};
    std::size_t zeros[2] = {0, 0};
    for (std::size_t i = 0; i < 2 * pairs; ++i) zeros[i % 2] += bytes[i] == '\0';
    if (zeros[0] == 0 && zeros[1] == pairs) return ByteOrder::Little;
    if (zeros[1] == 0 && zeros[0] == pairs) return ByteOrder::Big;
    return {};
}

std::string utf16ToUtf8(std::string_view bytes, ByteOrder order) {
    const auto unit = [&](std::size_t i) -> char32_t {
        const auto first = static_cast<unsigned char>(bytes[2 * i]);
        const auto second = static_cast<unsigned char>(bytes[2 * i + 1]);
        return order == ByteOrder::Little ? char32_t(first | second << 8) : char32_t(first << 8 | second);
    };
    std::string text;
    text.reserve(bytes.size() / 2);
    const std::size_t count = bytes.size() / 2;
    for (std::size_t i = count > 0 && unit(0) == 0xfeff ? 1 : 0; i < count; ++i) {
        const char32_t code = unit(i);
        const bool isHigh = code >= 0xd800 && code < 0xdc00, isLow = code >= 0xdc00 && code < 0xe000;
        if (isHigh && i + 1 < count && unit(i + 1) >= 0xdc00 && unit(i + 1) < 0xe000) {
            append(text, 0x10000 + ((code - 0xd800) << 10) + (unit(i + 1) - 0xdc00));
            ++i;
        } else {
            append(text, isHigh || isLow ? kReplacement : code);
        }
    }
    return text;
}

bool isUtf8(std::string_view bytes) {
    for (std::size_t at = asciiLength(bytes, 0); at < bytes.size(); at += asciiLength(bytes, at)) {
        const std::size_t length = sequenceLength(bytes, at);
        if (length == 0) return false;
        at += length;
    }
    return true;
}

std::string windows1252ToUtf8(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 8);
    for (std::size_t at = 0; at < bytes.size();) {
        if (const std::size_t length = sequenceLength(bytes, at)) {
            text.append(bytes.substr(at, length));
            at += length;
            continue;
        }
        const auto code = static_cast<unsigned char>(bytes[at++]);
        append(text, code < 0xa0 ? char32_t(kWindows1252[code - 0x80u]) : char32_t(code));
    }
    return text;
}

std::optional<std::string> utf8ToWindows1252(std::string_view text) {
    std::string bytes;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = sequenceLength(text, at);
        if (length == 0) return {};
        const char32_t code = codeAt(text, at, length);
        const auto special = std::find(kWindows1252.begin(), kWindows1252.end(), code);
        if (special != kWindows1252.end())
            bytes += static_cast<char>(0x80 + (special - kWindows1252.begin()));
        else if (code < 0x80 || (code >= 0xa0 && code < 0x100))
            bytes += static_cast<char>(code);
        else
            return {};
        at += length;
    }
    return bytes;
}

}  // namespace rayscope::scene
