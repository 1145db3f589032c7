#include "render/scene_defaults.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include "bvh/isa.h"
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
            if (assignment.key == "isa" && !bvh::isAvailable(settings.isa))
                throw InputError(
                    fmt::format("setting 'isa': this processor has no {}; use auto", assignment.value));
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

std::string optionText(const Lens& lens) {
    return fmt::format("{},{},{}", lens.fNumber, lens.focalLength, lens.focusDistance);
}

}  // namespace rayscope::render
