#include <rayscope/lab.h>

#include "scene/generate/generate.h"

namespace rayscope {

SceneDescription labShapes() {
    SceneDescription scene;
    scene.path = "shapes";
    scene.title = "Generated closed and open meshes";
    scene.materials.emplace_back();
    scene.cameras.emplace_back();
    const auto add = [&](const char* name, MeshData data, const glm::vec3& at) {
        MeshInstance mesh{.name = name,
                          .data = std::make_shared<MeshData>(std::move(data)),
                          .transform = {},
                          .materials = {0}};
        mesh.transform.translate = at;
        scene.meshes.push_back(std::move(mesh));
    };
    add("icosphere", scene::generate(scene::IcosphereShape{.subdivisions = 4}), {-3, 0, 0});
    add("needles", scene::generate(scene::UvSphereShape{.segments = 512, .rings = 4}), {0, 0, 0});
    add("box", scene::generate(scene::BoxShape{}), {3, 0, 0});
    add("torus", scene::generate(scene::TorusShape{}), {-3, 0, -3});
    add("monkey", scene::generate(scene::MonkeyShape{}), {0, 0, -3});
    add("terrain", scene::generate(scene::TerrainShape{.cellsX = 32, .cellsZ = 32}), {3, 0, -3});
    return scene;
}

}  // namespace rayscope
