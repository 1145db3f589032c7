#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rayscope::base {

/// The 32-bit number in four bytes, the lowest first; bytes.size() >= offset + 4.
constexpr std::uint32_t littleEndian32(std::string_view bytes, std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
    return value;
}

}  // namespace rayscope::base
