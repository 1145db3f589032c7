#pragma once
// Small scenes for tests with an exact result.
#include <rayscope/render_session.h>
#include <rayscope/scene.h>

#include <memory>

#include "trace/compile.h"

namespace rayscope::test {

/// A mesh of one parallelogram: corner, corner + a, corner + a + b, corner + b, with texture coordinates 0
/// … 1.
inline MeshInstance quad(const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b,
                         std::uint32_t material = 0) {
    auto data = std::make_shared<MeshData>();
    data->positions = {corner, corner + a, corner + a + b, corner + b};
    data->texCoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    data->triangles = {{0, 1, 2}, {0, 2, 3}};
    return {"quad", data, {}, {material}, glm::vec3(0.0f)};
}

inline Material material(const Rgb& kd, const Rgb& ks = Rgb(0.0f), float shininess = 1.0f,
                         float opacity = 1.0f) {
    Material m;
    m.name = "m";
    m.kd = kd;
    m.ks = ks;
    m.shininess = shininess;
    m.opacity = opacity;
    return m;
}

inline Light pointLight(const glm::vec3& position, const Rgb& color = Rgb(1.0f)) {
    return {PointLight{position, color}, Falloff::None};
}

/// A camera at (0, 0, distance) that looks at the origin.
inline CameraDescription frontCamera(float distance, float fov = 50.0f) {
    CameraDescription camera;
    camera.lookFrom = {0.0f, 0.0f, distance};
    camera.fov = fov;
    return camera;
}

/// An image of a square that fills the view, `size` pixels wide and high.
inline RenderRequest squareRequest(int size) {
    SceneDescription scene;
    scene.materials = {material(Rgb(0.5f))};
    scene.meshes = {quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0})};
    RenderRequest request;
    request.scene = std::make_shared<const SceneDescription>(scene);
    request.camera = frontCamera(3.0f);
    request.width = request.height = size;
    return request;
}

inline std::shared_ptr<const trace::World> compileScene(SceneDescription scene, const Settings& settings,
                                                        int width, int height) {
    if (scene.cameras.empty()) scene.cameras.push_back(frontCamera(3.0f));
    auto shared = std::make_shared<const SceneDescription>(std::move(scene));
    return trace::compile({shared, settings, shared->cameras.front(), width, height});
}

/// A built-in scene with square pictures.
inline std::shared_ptr<const trace::World> compileBuiltin(const std::string& name, int size,
                                                          const Settings& settings = {}) {
    Diagnostics notes;
    return compileScene(loadScene("builtin:" + name, notes), settings, size, size);
}

}  // namespace rayscope::test
