#include <fmt/format.h>
#include <rayscope/scene.h>

#include <algorithm>

#include "scene/check_description.h"

namespace rayscope {

namespace {

std::string counted(std::size_t count, std::string_view singular, std::string_view plural) {
    return fmt::format("{} {}", count, count == 1 ? singular : plural);
}

/// The materials that surfaces use; others have no requirements.
std::vector<const Material*> materialsInUse(const SceneDescription& scene) {
    std::vector<bool> used(scene.materials.size(), false);
    for (const MeshInstance& mesh : scene.meshes)
        for (const std::uint32_t material : mesh.materials) used[material] = true;
    for (const SphereInstance& sphere : scene.spheres) used[sphere.material] = true;
    std::vector<const Material*> list;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) list.push_back(&scene.materials[i]);
    return list;
}

class Collector {
  public:
    explicit Collector(const SceneDescription& scene) : scene_(scene), materials_(materialsInUse(scene)) {}

    SceneRequirements collect() {
        geometry();
        surfaces();
        lights();
        rest();
        return std::move(result_);
    }

  private:
    /// Appends a requirement that is needed by `count` objects. Returns whether there are any.
    bool add(std::string name, std::size_t count, std::string ifNeeded, std::string ifNot) {
        result_.list.push_back({std::move(name), count > 0, std::move(count > 0 ? ifNeeded : ifNot)});
        return count > 0;
    }

    void geometry() {
        std::size_t smooth = 0, colored = 0;
        for (const MeshInstance& mesh : scene_.meshes) {
            result_.triangles += mesh.data->triangles.size();
            smooth += !mesh.data->normals.empty();
            colored += mesh.vertexColors && !mesh.data->colors.empty();
        }
        result_.spheres = scene_.spheres.size();
        add("triangles", result_.triangles,
            fmt::format("{} in {}", counted(result_.triangles, "triangle", "triangles"),
                        counted(scene_.meshes.size(), "mesh", "meshes")),
            "no mesh");
        add("spheres", result_.spheres, counted(result_.spheres, "sphere", "spheres"), "no sphere");
        result_.smoothNormals = add("normal interpolation", smooth,
                                    counted(smooth, "mesh has vertex normals", "meshes have vertex normals"),
                                    "no mesh has vertex normals");
        result_.vertexColors = add("vertex colours", colored,
                                   counted(colored, "mesh shows its colours", "meshes show their colours"),
                                   "no mesh shows vertex colours");
    }

    template <class Test>
    bool ofMaterials(std::string name, const Test& test, std::string_view what, std::string ifNot) {
        std::size_t count = 0;
        std::string first;
        for (const Material* material : materials_)
            if (test(*material) && count++ == 0) first = material->name;
        const std::string more = count > 1 ? fmt::format(" and {} more", count - 1) : "";
        return add(std::move(name), count, fmt::format("{} of material '{}'{}", what, first, more),
                   std::move(ifNot));
    }

    void surfaces() {
        result_.textures = ofMaterials(
            "textures", [](const Material& m) { return m.kdTexture != nullptr; }, "kd_texture",
            "no material in use has a texture");
        result_.reflections = ofMaterials(
            "reflections", [](const Material& m) { return m.ks != Rgb(0.0f); }, "ks",
            "ks of all materials is 0");
        result_.transparency = ofMaterials(
            "transparency", [](const Material& m) { return m.opacity < 1.0f; }, "opacity",
            "all materials are opaque");
    }

    template <class Shape>
    bool lightsOf(const std::string& name) {
        const auto count = static_cast<std::size_t>(
            std::count_if(scene_.lights.begin(), scene_.lights.end(),
                          [](const Light& light) { return std::holds_alternative<Shape>(light.shape); }));
        const std::string singular = name.substr(0, name.size() - 1);
        return add(name, count, counted(count, singular, name), fmt::format("no {}", singular));
    }

    void lights() {
        result_.pointLights = lightsOf<PointLight>("point lights");
        result_.segmentLights = lightsOf<SegmentLight>("segment lights");
        result_.parallelogramLights = lightsOf<ParallelogramLight>("parallelogram lights");
    }

    void rest() {
        result_.environment =
            add("environment", scene_.environment ? 1 : 0, "an environment map", "no environment");
        const auto lenses = static_cast<std::size_t>(std::count_if(
            scene_.cameras.begin(), scene_.cameras.end(), [](const auto& c) { return !!c.lens; }));
        result_.lens = add("lens", lenses, counted(lenses, "camera has a lens", "cameras have a lens"),
                           "all cameras are pinholes");
        const auto moves = [](const auto& instance) { return instance.motion != glm::vec3(0.0f); };
        const auto moving =
            static_cast<std::size_t>(std::count_if(scene_.meshes.begin(), scene_.meshes.end(), moves) +
                                     std::count_if(scene_.spheres.begin(), scene_.spheres.end(), moves));
        result_.motion =
            add("motion", moving, counted(moving, "object moves", "objects move"), "no object moves");
    }

    const SceneDescription& scene_;
    std::vector<const Material*> materials_;
    SceneRequirements result_;
};

}  // namespace

SceneRequirements requirementsOf(const SceneDescription& scene) {
    scene::checkReferences(scene);
    return Collector(scene).collect();
}

}  // namespace rayscope
