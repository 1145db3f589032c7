#pragma once
// Base64 (RFC 4648, section 4).
#include <optional>
#include <string>
#include <string_view>

namespace rayscope::base {

/// With padding.
std::string base64Encoded(std::string_view bytes);

/// Nothing if the text is not base64. Padding may be missing.
std::optional<std::string> base64Decoded(std::string_view text);

}  // namespace rayscope::base
