// Entry point: selects the reader by file type, and completes bare meshes to scenes.
#include <fmt/format.h>
#include <rayscope/scene.h>

#include <algorithm>
#include <array>

#include "base/file_suffix.h"
#include "base/nearest_name.h"
#include "scene/mesh_files/read_mesh_file.h"
#include "scene/source_files.h"
#include "scene/toml/scene.h"

namespace rayscope {

namespace {

constexpr std::string_view kBuiltin = "builtin:";

/// In the order of menus and lists.
constexpr std::array<std::string_view, 18> kBuiltinNames{"cornell",
                                                         "cornell-area",
                                                         "cornell-glossy",
                                                         "cornell-transparent",
                                                         "monkey",
                                                         "teapot",
                                                         "dragon",
                                                         "spheres",
                                                         "spheres-dof",
                                                         "environment",
                                                         "cubes-transparent",
                                                         "cube",
                                                         "cube-textured",
                                                         "quad-textured",
                                                         "triangle",
                                                         "custom",
                                                         "million",
                                                         "ten-million"};

/// A point light to the upper left of the camera and slightly behind it, for visible shading and shadows that
/// fall away from the viewer.
Light lightBeside(const CameraDescription& camera) {
    const glm::dvec3 from(camera.lookFrom), view = glm::dvec3(camera.lookAt) - from;
    const double distance = glm::length(view);
    const glm::dvec3 forward = view / distance;
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
    const glm::dvec3 up = glm::cross(right, forward);
    return {PointLight{glm::vec3(from + distance * (0.6 * up - 0.5 * right - 0.1 * forward))}};
}

SceneDescription loadBareMesh(const std::string& path, Diagnostics& notes, const LoadControl& control) {
    scene::TextureCache textures(notes, control);
    scene::ImportedMesh mesh = scene::readMeshFile(path, {textures, notes, control});
    SceneDescription scene;
    scene.path = path;
    scene.materials = std::move(mesh.materials);
    MeshInstance instance{.name = path, .data = std::move(mesh.data)};
    for (std::uint32_t slot = 0; slot < scene.materials.size(); ++slot) instance.materials.push_back(slot);
    scene.meshes.push_back(std::move(instance));
    scene.cameras = std::move(mesh.cameras);
    if (scene.cameras.empty()) scene.cameras.push_back(framingCamera(boundsOf(scene, control)));
    scene.lights = std::move(mesh.lights);
    if (scene.lights.empty()) scene.lights.push_back(lightBeside(scene.cameras.front()));
    return scene;
}

SceneDescription loadBuiltin(const std::string& path, Diagnostics& notes, const LoadControl& control) {
    const std::string_view name = std::string_view(path).substr(kBuiltin.size());
    if (std::find(kBuiltinNames.begin(), kBuiltinNames.end(), name) == kBuiltinNames.end())
        throw InputError(fmt::format("unknown built-in scene '{}'{}; expected {}", name,
                                     base::didYouMean(name, kBuiltinNames),
                                     base::joinChoices(kBuiltinNames)));
    const std::string file = path + ".toml";
    SceneDescription scene = scene::readTomlScene(file, scene::readSource(file, control), notes, control);
    scene.path = path;
    return scene;
}

}  // namespace

SceneDescription loadScene(const std::string& path, Diagnostics& notes, const LoadControl& control) {
    if (path.starts_with(kBuiltin)) return loadBuiltin(path, notes, control);
    if (scene::isMeshFileName(path)) return loadBareMesh(path, notes, control);
    if (base::hasSuffix(path, ".toml"))
        return scene::readTomlScene(path, scene::readSource(path, control), notes, control);
    throw InputError(
        fmt::format("unknown scene format; expected a .toml file, a mesh file ({}) or builtin:NAME",
                    fmt::join(scene::meshFileSuffixes(), ", ")),
        {path});
}

std::vector<std::string> sceneFileSuffixes() {
    std::vector<std::string> suffixes{".toml"};
    for (const std::string_view suffix : scene::meshFileSuffixes()) suffixes.emplace_back(suffix);
    return suffixes;
}

std::vector<BuiltinScene> builtinScenes() {
    std::vector<BuiltinScene> list;
    for (const std::string_view name : kBuiltinNames) {
        const std::string file = fmt::format("{}{}.toml", kBuiltin, name);
        list.push_back({std::string(name), scene::titleOf(file, scene::readSource(file))});
    }
    return list;
}

}  // namespace rayscope
