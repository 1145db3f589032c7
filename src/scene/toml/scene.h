#pragma once
#include <rayscope/scene.h>

#include <string_view>

namespace rayscope::scene {

/// Reads the text of a scene file and the files that it names. `path` is the name in messages and the base of
/// relative paths. Throws InputError at the first error, and Stopped; appends warnings to `notes`.
SceneDescription readTomlScene(const std::string& path, std::string_view text, Diagnostics& notes,
                               const LoadControl& control = {});

/// The title of a scene file, or "". Opens no other file.
std::string titleOf(const std::string& path, std::string_view text);

}  // namespace rayscope::scene
