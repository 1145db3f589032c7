#pragma once
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace rayscope::base {

/// The value as JSON text that ends in a line feed. It is valid for any content: bytes that are not UTF-8
/// become U+FFFD, NaN and infinity null, control characters escapes. `indent`: blanks per level; -1 writes
/// one line.
std::string jsonText(const nlohmann::json& value, int indent = 2);

}  // namespace rayscope::base
