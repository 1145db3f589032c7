#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace rayscope::scene {

/// Whether the bytes are UTF-32: by a byte order mark, or because three of four of the first bytes are zero.
bool isUtf32(std::string_view bytes);

enum class ByteOrder { Little, Big };

/// The byte order mark in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// The byte order if the bytes are UTF-16: by a byte order mark, or because every other one of the first
/// bytes is zero.
std::optional<ByteOrder> utf16Order(std::string_view bytes);

/// Without the byte order mark; halves of surrogate pairs become U+FFFD.
std::string utf16ToUtf8(std::string_view bytes, ByteOrder order);

/// Whether the bytes are valid UTF-8 (RFC 3629).
bool isUtf8(std::string_view bytes);

/// Valid sequences of UTF-8 stay, all other bytes are read as Windows-1252, a superset of the printable part
/// of Latin-1.
std::string windows1252ToUtf8(std::string_view bytes);

/// The text in Windows-1252, the inverse of windows1252ToUtf8(); nothing if the text is not UTF-8 or has a
/// character that the code page lacks.
std::optional<std::string> utf8ToWindows1252(std::string_view text);

}  // namespace rayscope::scene
