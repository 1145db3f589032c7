#pragma once
// A scene that uses all effects.
#include <cmath>
#include <numbers>

#include "support/environments.h"
#include "support/test_scenes.h"

namespace rayscope::test {

/// A wavy sheet over [−1, 1]² with vertex normals and texture coordinates.
inline std::shared_ptr<MeshData> wavySheet(int cells) {
    auto mesh = std::make_shared<MeshData>();
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            const double x = 2.0 * i / cells - 1.0, z = 2.0 * j / cells - 1.0, k = 4.0;
            mesh->positions.push_back(glm::vec3(glm::dvec3(x, 0.1 * std::sin(k * x) * std::cos(k * z), z)));
            mesh->normals.push_back(
                glm::vec3(glm::normalize(glm::dvec3(-0.1 * k * std::cos(k * x) * std::cos(k * z), 1.0,
                                                    0.1 * k * std::sin(k * x) * std::sin(k * z)))));
            mesh->texCoords.push_back(glm::vec2(glm::dvec2(3.0 * i / cells, 3.0 * j / cells)));
        }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            mesh->triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
            mesh->triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    return mesh;
}

inline SceneDescription allEffectsScene() {
    SceneDescription scene;
    auto checks = std::make_shared<Texture>();
    checks->image = RgbImage(4, 4);
    for (int i = 0; i < 16; ++i)
        checks->image.pixels[static_cast<std::size_t>(i)] =
            (i + i / 4) % 2 ? Rgb(0.9f, 0.3f, 0.1f) : Rgb(0.1f, 0.4f, 0.8f);

    scene.materials = {material(Rgb(0.5f), Rgb(0.4f), 20.0f),
                       material({0.2f, 0.6f, 0.3f}, Rgb(0.2f), 5.0f, 0.4f),
                       material({0.7f, 0.2f, 0.2f}, Rgb(0.6f), 200.0f)};
    scene.materials[0].kdTexture = checks;
    scene.meshes = {{"sheet", wavySheet(16), {}, {0}, glm::vec3(0)},
                    quad({-0.8f, 0.2f, 0.5f}, {1, 0, 0}, {0, 1, 0.2f}, 1)};
    scene.meshes[0].transform.translate = {0, -0.4f, 0};
    scene.spheres = {{"moving", {{0.3f, 0.2f, 0}, 0.35f}, 2, glm::vec3(0.2f, 0.1f, 0)},
                     {"resting", {{-0.4f, 0, -0.3f}, 0.3f}, 1, glm::vec3(0)}};
    scene.lights = {pointLight({1, 2, 2}, {0.8f, 0.7f, 0.6f}),
                    {SegmentLight{{glm::vec3(-1, 1.5f, 1), glm::vec3(1, 1.6f, -1)},
                                  {Rgb(0.9f, 0.1f, 0.1f), Rgb(0.1f, 0.3f, 0.9f)}},
                     Falloff::None},
                    {ParallelogramLight{{-0.6f, 1.8f, -0.2f},
                                        {glm::vec3(0.6f, 0, 0), glm::vec3(0, 0.1f, 0.7f)},
                                        {Rgb(0.5f), Rgb(0.1f, 0.5f, 0.1f), Rgb(0.4f), Rgb(0.9f)}},
                     Falloff::InverseSquare}};
    scene.environment = cubeOf(8, [](const glm::dvec3& d) { return Rgb(glm::vec3(0.5 + 0.5 * d)); });
    CameraDescription camera;
    camera.lookFrom = {0.4f, 1.2f, 2.6f};
    camera.lens = Lens{1.4f, 0.3f, 2.4f};
    scene.cameras = {camera};
    return scene;
}

}  // namespace rayscope::test
