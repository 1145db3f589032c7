#include <rayscope/scene.h>

#include <algorithm>

#include "base/check_argument.h"
#include "scene/check_description.h"

namespace rayscope {

namespace {

using base::checkArgument;

void checkTexture(const Texture& texture, std::string_view owner) {
    const RgbImage& image = texture.image;
    checkArgument(image.width > 0 && image.height > 0 && hasAllPixels(image),
                  "{}: image of {} x {} pixels with {} stored pixels", owner, image.width, image.height,
                  image.pixels.size());
}

void checkInstance(const MeshInstance& mesh, std::size_t number, std::size_t materials) {
    checkArgument(mesh.data != nullptr, "meshes[{}]: data is null", number);
    checkArgument(!mesh.materials.empty(), "meshes[{}]: materials is empty", number);
    for (const std::uint32_t index : mesh.materials)
        checkArgument(index < materials, "meshes[{}]: material index {}, but there are {} materials", number,
                      index, materials);
}

void checkEnvironment(const Environment& environment) {
    if (environment.equirect) return checkTexture(*environment.equirect, "environment.equirect");
    for (const std::shared_ptr<const Texture>& face : environment.cube) {
        checkArgument(face != nullptr, "environment: neither equirect nor all six faces of cube are set");
        checkTexture(*face, "environment.cube");
    }
}

}  // namespace

void checkMesh(const MeshData& mesh) {
    const std::size_t vertices = mesh.positions.size();
    const auto checkSize = [&](std::size_t size, std::string_view what) {
        checkArgument(size == 0 || size == vertices, "mesh: {} {} for {} positions", size, what, vertices);
    };
    checkSize(mesh.normals.size(), "normals");
    checkSize(mesh.texCoords.size(), "texCoords");
    checkSize(mesh.colors.size(), "colors");
    checkArgument(mesh.materialSlots.empty() || mesh.materialSlots.size() == mesh.triangles.size(),
                  "mesh: {} materialSlots for {} triangles", mesh.materialSlots.size(),
                  mesh.triangles.size());
    for (const glm::uvec3& triangle : mesh.triangles)
        checkArgument(std::max({triangle.x, triangle.y, triangle.z}) < vertices,
                      "mesh: triangle with vertex indices {}, {}, {}, but there are {} positions", triangle.x,
                      triangle.y, triangle.z, vertices);
}

namespace scene {

void checkReferences(const SceneDescription& scene) {
    const std::size_t materials = scene.materials.size();
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) checkInstance(scene.meshes[i], i, materials);
    for (const SphereInstance& sphere : scene.spheres)
        checkArgument(sphere.material < materials,
                      "sphere '{}': material index {}, but there are {} materials", sphere.name,
                      sphere.material, materials);
    for (const Material& material : scene.materials)
        if (material.kdTexture) checkTexture(*material.kdTexture, material.name);
    if (scene.environment) checkEnvironment(*scene.environment);
}

void checkSlots(const MeshInstance& mesh) {
    for (const std::uint16_t slot : mesh.data->materialSlots)
        checkArgument(slot < mesh.materials.size(), "mesh '{}': material slot {}, but it has {} materials",
                      mesh.name, slot, mesh.materials.size());
}

}  // namespace scene

void checkDescription(const SceneDescription& scene) {
    scene::checkReferences(scene);
    for (const MeshInstance& mesh : scene.meshes) {
        checkMesh(*mesh.data);
        scene::checkSlots(mesh);
    }
}

}  // namespace rayscope
