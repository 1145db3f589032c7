#pragma once
#include <cstdint>
#include <string>

namespace rayscope::base {

/// "0.42 s", "32 s", "5 min 32 s", "2 h 05 min" or "44 d 20 h".
std::string durationText(double seconds);

/// "512 bytes", "3.3 KiB", "3.3 MiB" or "3.3 GiB".
std::string byteText(std::uint64_t bytes);

}  // namespace rayscope::base
