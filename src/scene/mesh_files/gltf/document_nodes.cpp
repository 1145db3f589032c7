// Scenes, nodes, cameras and lights of a glTF document.
#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "scene/mesh_files/gltf/document.h"

namespace rayscope::scene {

namespace {

void readCameras(const JsonObject& root, GltfDocument& document) {
    for (const JsonObject& object : root.objects("cameras")) {
        GltfCamera camera{.name = object.text("name")};
        const std::string type = object.text("type");
        if (type != "perspective" && type != "orthographic")
            object.fail("type", fmt::format("expected perspective or orthographic, got '{}'", type));
        camera.isPerspective = type == "perspective";
        if (camera.isPerspective) {
            const JsonObject perspective = object.requiredObject("perspective");
            camera.yfov = perspective.number("yfov", 0.0);
            if (!(camera.yfov > 0.0 && camera.yfov < std::numbers::pi))
                perspective.fail("yfov",
                                 fmt::format("expected an angle between 0 and π, got {}", camera.yfov));
        }
        document.cameras.push_back(camera);
    }
}

void readLights(const JsonObject& root, GltfDocument& document, Oddities& oddities) {
    const auto punctual = root.extension("KHR_lights_punctual");
    if (!punctual) return;
    for (const JsonObject& object : punctual->objects("lights")) {
        GltfLight light{.name = object.text("name"),
                        .type = object.text("type"),
                        .intensity = object.number("intensity", 1.0)};
        if (const auto v = object.numbers("color", 3); !v.empty()) light.color = {v[0], v[1], v[2]};
        if (light.type != "point" && light.type != "directional" && light.type != "spot")
            object.fail("type", fmt::format("expected point, directional or spot, got '{}'", light.type));
        if (light.intensity < 0.0) object.fail("intensity", "expected at least 0");
        if (glm::any(glm::lessThan(light.color, glm::dvec3(0.0))))
            object.fail("color", "expected at least 0");
        if (object.has("range")) oddities.add(Severity::Note, "lights with a range; the range is ignored");
        document.lights.push_back(light);
    }
}

glm::dmat4 transformOf(const JsonObject& object, Oddities& oddities) {
    const auto matrix = object.numbers("matrix", 16);
    const auto translation = object.numbers("translation", 3), scale = object.numbers("scale", 3);
    const auto rotation = object.numbers("rotation", 4);
    if (!matrix.empty()) {
        if (!translation.empty() || !rotation.empty() || !scale.empty())
            oddities.add(Severity::Warning,
                         "nodes with a matrix and other transforms; only the matrix is used");
        glm::dmat4 result;
        for (int i = 0; i < 16; ++i) result[i / 4][i % 4] = matrix[static_cast<std::size_t>(i)];
        if (matrix[3] != 0.0 || matrix[7] != 0.0 || matrix[11] != 0.0 || matrix[15] != 1.0)
            object.fail("matrix",
                        "expected an affine map: the numbers 4, 8 and 12 must be 0 and number 16 must be 1");
        return result;
    }
    glm::dmat4 result(1.0);
    if (!rotation.empty()) {
        glm::dquat q(rotation[3], rotation[0], rotation[1], rotation[2]);
        const double length = glm::length(q);
        if (!(length > 0.0)) object.fail("rotation", "the quaternion has the length 0");
        constexpr double kTolerance =
            0.01;  // components are often stored with a few digits or as 8-bit integers
        if (std::abs(length - 1.0) > kTolerance)
            oddities.add(Severity::Warning, "rotations that are not unit quaternions; normalized");
        result = glm::mat4_cast(q / length);
    }
    if (!scale.empty())
        for (int axis = 0; axis < 3; ++axis) result[axis] *= scale[static_cast<std::size_t>(axis)];
    if (!translation.empty()) result[3] = glm::dvec4(translation[0], translation[1], translation[2], 1.0);
    return result;
}

GltfNode readNode(const JsonObject& object, std::size_t nodes, const GltfDocument& document,
                  Oddities& oddities) {
    GltfNode node{.name = object.text("name"),
                  .children = object.indices("children", nodes, "nodes"),
                  .matrix = transformOf(object, oddities),
                  .mesh = object.index("mesh", document.meshes.size(), "meshes"),
                  .camera = object.index("camera", document.cameras.size(), "cameras"),
                  .skin = object.index("skin", document.skins.size(), "skins"),
                  .weights = object.numbers("weights")};
    if (const auto light = object.extension("KHR_lights_punctual"))
        node.light = light->requiredIndex("light", document.lights.size(), "lights");
    if (const auto instancing = object.extension("EXT_mesh_gpu_instancing"))
        node.instances = readGltfAttributes(instancing->requiredObject("attributes"), document);
    return node;
}

/// The nodes that are nobody's child.
std::vector<std::uint32_t> rootsOf(const std::vector<GltfNode>& nodes) {
    std::vector<bool> isChild(nodes.size(), false);
    for (const GltfNode& node : nodes)
        for (const std::uint32_t child : node.children) isChild[child] = true;
    std::vector<std::uint32_t> roots;
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
        if (!isChild[i]) roots.push_back(i);
    return roots;
}

}  // namespace

void readGltfNodes(const JsonObject& root, GltfDocument& document, Oddities& oddities) {
    readCameras(root, document);
    readLights(root, document, oddities);
    const std::size_t nodes = root.sizeOf("nodes");
    for (const JsonObject& object : root.objects("skins"))
        document.skins.push_back({.inverseBindMatrices = object.index("inverseBindMatrices",
                                                                      document.accessors.size(), "accessors"),
                                  .joints = object.indices("joints", nodes, "nodes")});
    for (const JsonObject& object : root.objects("nodes"))
        document.nodes.push_back(readNode(object, nodes, document, oddities));
    const std::vector<JsonObject> scenes = root.objects("scenes");
    const GltfIndex chosen = root.index("scene", scenes.size(), "scenes");
    for (const JsonObject& scene : scenes) scene.text("name");
    if (scenes.empty()) {
        oddities.add(Severity::Note, "no scene; all nodes are read");
        document.roots = rootsOf(document.nodes);
        return;
    }
    document.roots = scenes[chosen.value_or(0)].indices("nodes", nodes, "nodes");
    if (scenes.size() > 1)
        oddities.add(Severity::Note,
                     fmt::format("{} scenes; only scene {} is read", scenes.size(), chosen.value_or(0)));
}

}  // namespace rayscope::scene
