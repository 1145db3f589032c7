#include "scene/mesh_files/gltf/cameras_and_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "math/vectors.h"

namespace rayscope::scene {

namespace {

glm::dvec3 centerOf(const SceneBounds& bounds) {
    return 0.5 * (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper));
}

double diagonalOf(const SceneBounds& bounds) {
    return glm::length(glm::dvec3(bounds.upper) - glm::dvec3(bounds.lower));
}

std::string uniqueName(std::string name, const std::vector<CameraDescription>& cameras) {
    if (name.empty()) name = cameras.empty() ? "main" : fmt::format("camera {}", cameras.size() + 1);
    const auto isTaken = [&](const std::string& candidate) {
        return std::any_of(cameras.begin(), cameras.end(),
                           [&](const auto& c) { return c.name == candidate; });
    };
    std::string candidate = name;
    for (int i = 2; isTaken(candidate); ++i) candidate = fmt::format("{} {}", name, i);
    return candidate;
}

}  // namespace

std::vector<CameraDescription> gltfCameras(const GltfDocument& document,
                                           const std::vector<GltfPlacement>& placed,
                                           const SceneBounds& bounds, Oddities& oddities) {
    std::vector<CameraDescription> cameras;
    for (const GltfPlacement& placement : placed) {
        const GltfCamera& camera = document.cameras[placement.index];
        if (!camera.isPerspective) {
            oddities.add(Severity::Note, "orthographic cameras; left out");
            continue;
        }
        const std::string& node = document.nodes[placement.node].name;
        // The camera of the format looks along −z, with y up.
        const glm::dvec3 position(placement.toScene[3]);
        const glm::dvec3 back(placement.toScene[2]), up(placement.toScene[1]);
        const glm::dvec3 forward = -glm::normalize(back);
        const double depth = glm::dot(centerOf(bounds) - position, forward);
        const double distance =
            depth > 0.0 ? depth : std::max(diagonalOf(bounds), glm::length(position) * 1e-3);
        CameraDescription description{.name = uniqueName(node.empty() ? camera.name : node, cameras),
                                      .lookFrom = glm::vec3(position),
                                      .lookAt = glm::vec3(position + forward * distance),
                                      .up = glm::vec3(glm::normalize(up)),
                                      .fov = static_cast<float>(camera.yfov * 180.0 / std::numbers::pi),
                                      .lens = std::nullopt};
        const glm::dvec3 view = glm::dvec3(description.lookAt) - glm::dvec3(description.lookFrom);
        const glm::dvec3 side = glm::cross(glm::normalize(view), glm::dvec3(description.up));
        if (!math::isFinite(description.lookFrom) || !math::isFinite(description.lookAt) ||
            !(glm::length(side) > 1e-6)) {  // far above the rounding of float, far below any real camera
            oddities.add(Severity::Warning, "cameras whose transform is singular or not finite; left out");
            continue;
        }
        cameras.push_back(description);
    }
    return cameras;
}

std::vector<Light> gltfLights(const GltfDocument& document, const std::vector<GltfPlacement>& placed,
                              const SceneBounds& bounds, Oddities& oddities) {
    constexpr double kDistance = 1000.0;  // diagonals; directions within the scene differ by 0.001 radians
    std::vector<Light> lights;
    for (const GltfPlacement& placement : placed) {
        const GltfLight& light = document.lights[placement.index];
        PointLight point{.position = glm::vec3(placement.toScene[3]),
                         .color = Rgb(light.color * (light.intensity / std::numbers::pi))};
        Falloff falloff = Falloff::InverseSquare;
        if (light.type == "spot") {
            oddities.add(Severity::Warning, "spot lights; left out");
            continue;
        }
        if (light.type == "directional") {
            const glm::dvec3 back = glm::normalize(glm::dvec3(placement.toScene[2]));
            point.position = glm::vec3(centerOf(bounds) + back * (kDistance * diagonalOf(bounds)));
            falloff = Falloff::None;
            oddities.add(Severity::Note, "directional lights; distant point lights are used");
        }
        if (!math::isFinite(point.position) || !math::isFinite(point.color)) {
            oddities.add(Severity::Warning, "lights whose position or colour is not finite; left out");
            continue;
        }
        lights.push_back({point, falloff});
    }
    return lights;
}

}  // namespace rayscope::scene
