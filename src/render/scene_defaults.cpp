#include "render/scene_defaults.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include "bvh/isa.h"

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
            if (assignment.key == "isa" && !bvh::isAvailable(settings.isa))
                throw InputError(
                    fmt::format("setting 'isa': this processor has no {}; use auto", assignment.value));
        } catch (const InputError& error) {
            throw InputError(error.diagnostic().message, assignment.position);
        }
    }
}

void checkCamera(const CameraDescription& camera) {
    if (camera.lookFrom == camera.lookAt)
        throw InputError("--look-from and --look-at of the camera are the same point; move one of them");
}

std::string optionText(const glm::vec3& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

}  // namespace rayscope::render
