#pragma once
#include <toml++/toml.h>

#include <string>
#include <string_view>

namespace rayscope::scene {

/// Parses a TOML file. Throws InputError with the position of the first error, also where keys nest deeper
/// than the stack of the recursive parser allows.
toml::table parseToml(const std::string& path, std::string_view text);

}  // namespace rayscope::scene
