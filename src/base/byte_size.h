#pragma once
// Amounts of memory as text.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rayscope::base {

/// "812 bytes", "3.1 MB", "12 GB": in powers of 1000.
std::string byteSizeText(std::uint64_t bytes);

/// The number of bytes that a text such as "500M", "1.5GB" or "2 GiB" spells, with K, M, G or T in any case:
/// alone and with iB powers of 1024, with B powers of 1000. Nothing for other texts, such as numbers without
/// a unit, and for what is not from 1 byte to 2^63.
std::optional<std::uint64_t> parseByteSize(std::string_view text);

}  // namespace rayscope::base
