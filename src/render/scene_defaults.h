#pragma once
// What a request has where nothing overrides the scene, and the camera as command-line options.
#include <rayscope/scene.h>
#include <rayscope/settings.h>
#include <string>

namespace rayscope::render {

/// The first camera of the scene, or one that frames it if it has none.
CameraDescription defaultCamera(const SceneDescription& scene);

/// The defaults, overridden by the scene file. Throws InputError with the position of a wrong setting.
Settings settingsOf(const SceneDescription& scene);

/// Overrides settings in order. Throws InputError with the position of a wrong one.
void assignAll(Settings& settings, const std::vector<SettingAssignment>& assignments);

/// Throws InputError if the camera is at the point that it looks at, or `up` is zero or parallel to the view.
void checkCamera(const CameraDescription& camera);

/// "x,y,z", as --look-from and the like take it; reads back as the same floats.
std::string optionText(const glm::vec3& v);

/// "F,FOCAL,DISTANCE", as --lens takes it.
std::string optionText(const Lens& lens);

}  // namespace rayscope::render
