#include "render/scene_defaults.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include "scene/check_camera.h"

namespace rayscope::render {

CameraDescription defaultCamera(const SceneDescription& scene) {
    return scene.cameras.empty() ? framingCamera(boundsOf(scene)) : scene.cameras.front();
}

Settings settingsOf(const SceneDescription& scene) {
    Settings settings;
    assignAll(settings, scene.settings);
    return settings;
}

void assignAll(Settings& settings, const std::vector<SettingAssignment>& assignments) {
    for (const SettingAssignment& assignment : assignments) {
        try {
            assign(settings, assignment.key, assignment.value);
        } catch (const InputError& error) {
            throw InputError(error.diagnostic().message, assignment.position);
        }
    }
}

void checkCamera(const CameraDescription& camera) {
    if (const std::string_view problem = scene::problemOf(camera); !problem.empty())
        throw InputError(fmt::format("camera: {}", problem));
}

std::string optionText(const glm::vec3& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

}  // namespace rayscope::render
