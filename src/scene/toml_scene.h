#pragma once
#include <rayscope/scene.h>

#include <string_view>

namespace rayscope::scene {

/// Reads the text of a scene file. `path` names it in messages and anchors relative paths.
SceneDescription readTomlScene(const std::string& path, std::string_view text, Diagnostics& notes);

/// The `title` of a scene file, without opening anything else that it names.
std::string titleOf(const std::string& path, std::string_view text);

}  // namespace rayscope::scene
