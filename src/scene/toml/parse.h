#pragma once
#include <rayscope/scene.h>
#include <toml++/toml.h>

#include <string>
#include <string_view>

namespace rayscope::scene {

/// Parses a TOML file. Throws InputError with the position of the first error, also where keys nest deeper
/// than the stack of the recursive parser allows, and Stopped.
toml::table parseToml(const std::string& path, std::string_view text, const LoadControl& control = {});

}  // namespace rayscope::scene
