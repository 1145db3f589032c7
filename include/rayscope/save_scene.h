#pragma once
#include <rayscope/scene.h>
#include <string>

namespace rayscope {

/// The text of a scene file that has the cameras, lights and settings of `scene`, and all else of the file
/// that it was loaded from: of a .toml file or a built-in scene the text with those values changed that
/// differ, so that comments and order stay. References to files are changed to be valid at `path`. Loading
/// the text at `path` gives the same cameras, lights and settings, bit for bit. Throws InputError where that
/// is impossible.
std::string savedSceneText(const SceneDescription& scene, const std::string& path);

/// Writes savedSceneText() to the file. Throws InputError.
void saveScene(const SceneDescription& scene, const std::string& path);

}  // namespace rayscope
