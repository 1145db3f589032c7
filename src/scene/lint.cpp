#include <fmt/format.h>
#include <rayscope/scene.h>

#include <algorithm>
#include <cmath>

#include "math/vectors.h"
#include "scene/lint_range.h"
#include "scene/load_step.h"
#include "scene/missing_content.h"

namespace rayscope {

namespace {

class Linter {
  public:
    Linter(const SceneDescription& scene, const LoadControl& control) : scene_(scene), control_(control) {}

    Diagnostics run() {
        for (const MeshInstance& mesh : scene_.meshes) lintMesh(mesh);
        lintMaterials();
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) lintLight(scene_.lights[i], i);
        for (const CameraDescription& camera : scene_.cameras) lintCamera(camera);
        for (Diagnostic& found : scene::missingContent(scene_)) found_.push_back(std::move(found));
        for (Diagnostic& found : scene::lintRange(scene_, control_)) found_.push_back(std::move(found));
        return std::move(found_);
    }

  private:
    void warn(std::string message) {
        found_.push_back({Severity::Warning, std::move(message), {scene_.path}});
    }
    void note(std::string message) { found_.push_back({Severity::Note, std::move(message), {scene_.path}}); }

    void lintMesh(const MeshInstance& mesh) {
        const MeshData& data = *mesh.data;
        scene::LoadStep step(control_, fmt::format("checking mesh '{}'", mesh.name),
                             2 * data.triangles.size());
        std::size_t nonFinite = 0, degenerate = 0, firstDegenerate = 0;
        for (std::size_t i = 0; i < data.triangles.size(); ++i) {
            step.advance();
            const glm::uvec3 t = data.triangles[i];
            const glm::vec3 a = data.positions[t.x], b = data.positions[t.y], c = data.positions[t.z];
            if (!math::isFinite(a) || !math::isFinite(b) || !math::isFinite(c)) {
                ++nonFinite;
                continue;
            }
            const glm::dvec3 area = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
            if (area == glm::dvec3(0.0) && degenerate++ == 0) firstDegenerate = i;
        }
        if (nonFinite > 0)
            warn(fmt::format("mesh '{}': {} triangles have NaN or infinite vertices; rays never hit them",
                             mesh.name, nonFinite));
        if (degenerate > 0)
            note(fmt::format("mesh '{}': {} degenerate triangles (zero area), the first has index {}",
                             mesh.name, degenerate, firstDegenerate));
        lintNormals(mesh, step);
        lintColors(mesh);
        lintTexCoords(mesh);
    }

    void lintNormals(const MeshInstance& mesh, scene::LoadStep& step) {
        const MeshData& data = *mesh.data;
        const auto isInvalid = [](const glm::vec3& n) { return !math::isFinite(n) || n == glm::vec3(0.0f); };
        const auto invalid = std::count_if(data.normals.begin(), data.normals.end(), isInvalid);
        if (invalid > 0)
            warn(fmt::format("mesh '{}': {} vertex normals are zero or not finite", mesh.name, invalid));
        if (data.normals.empty()) return;
        std::size_t flipped = 0;
        for (const glm::uvec3& t : data.triangles) {
            step.advance();
            const glm::dvec3 a(data.positions[t.x]), b(data.positions[t.y]), c(data.positions[t.z]);
            const glm::dvec3 area = glm::cross(b - a, c - a);
            const auto opposes = [&](std::uint32_t i) {
                return glm::dot(glm::dvec3(data.normals[i]), area) < 0.0;
            };
            flipped += opposes(t.x) && opposes(t.y) && opposes(t.z);
        }
        if (flipped > 0)
            note(fmt::format("mesh '{}': {} of {} triangles are oriented against their vertex normals",
                             mesh.name, flipped, data.triangles.size()));
    }

    void lintColors(const MeshInstance& mesh) {
        if (!mesh.vertexColors || mesh.data->colors.empty()) return;
        Rgb brightest(0.0f), mirror(0.0f);
        for (const Rgb& color : mesh.data->colors) brightest = glm::max(brightest, color);
        for (const std::uint32_t index : mesh.materials)
            mirror = glm::max(mirror, scene_.materials[index].ks);
        const Rgb sum = brightest + mirror;
        const float largest = std::max({sum.r, sum.g, sum.b});
        if (largest > 1.0f + 0x1p-22f)
            note(fmt::format("mesh '{}' is not energy-conserving: vertex colour + ks = {:.3g}", mesh.name,
                             largest));
    }

    void lintTexCoords(const MeshInstance& mesh) {
        if (!mesh.data->texCoords.empty()) return;
        for (const std::uint32_t index : mesh.materials)
            if (const Material& material = scene_.materials[index]; material.kdTexture) {
                warn(
                    fmt::format("mesh '{}' has no texture coordinates; the texture of material '{}' is "
                                "sampled at (0, 0) only",
                                mesh.name, material.name));
                return;
            }
    }

    void lintMaterials() {
        std::vector<bool> used(scene_.materials.size(), false);
        for (const MeshInstance& mesh : scene_.meshes)
            for (const std::uint32_t material : mesh.materials) used[material] = true;
        for (const SphereInstance& sphere : scene_.spheres) used[sphere.material] = true;
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) lintMaterial(scene_.materials[i], used[i]);
    }

    void lintMaterial(const Material& material, bool used) {
        if (!used) note(fmt::format("material '{}' is not used", material.name));
        const Rgb kd = material.kdTexture ? maximumOf(*material.kdTexture) : material.kd;
        const Rgb sum = kd + material.ks;
        const float largest = std::max({sum.r, sum.g, sum.b});
        // Fractions with an exact sum of 1 may exceed it by the rounding of two floats.
        if (largest > 1.0f + 0x1p-22f)
            note(fmt::format("material '{}' is not energy-conserving: kd + ks = {:.3g}", material.name,
                             largest));
        if (material.ks != Rgb(0.0f) && material.shininess == 0.0f)
            note(fmt::format("material '{}' has ks and shininess 0: its highlight covers the hemisphere",
                             material.name));
    }

    Rgb maximumOf(const Texture& texture) const {
        scene::LoadStep step(control_, fmt::format("checking texture '{}'", texture.file),
                             texture.image.pixels.size());
        Rgb maximum(0.0f);
        for (const Rgb& pixel : texture.image.pixels) {
            step.advance();
            maximum = glm::max(maximum, pixel);
        }
        return maximum;
    }

    void lintLight(const Light& light, std::size_t index) {
        if (const auto* segment = std::get_if<SegmentLight>(&light.shape))
            if (segment->endpoints[0] == segment->endpoints[1])
                note(
                    fmt::format("light {}: the segment has zero length; a point light is faster", index + 1));
        if (const auto* area = std::get_if<ParallelogramLight>(&light.shape))
            if (glm::cross(glm::dvec3(area->edges[0]), glm::dvec3(area->edges[1])) == glm::dvec3(0.0))
                note(fmt::format("light {}: the parallelogram has zero area", index + 1));
        const bool isBlack =
            std::visit([](const auto& shape) { return sumOf(shape) == Rgb(0.0f); }, light.shape);
        if (isBlack) note(fmt::format("light {} is black", index + 1));
    }
    static Rgb sumOf(const PointLight& light) { return light.color; }
    static Rgb sumOf(const SegmentLight& light) { return light.colors[0] + light.colors[1]; }
    static Rgb sumOf(const ParallelogramLight& light) {
        return light.colors[0] + light.colors[1] + light.colors[2] + light.colors[3];
    }

    void lintCamera(const CameraDescription& camera) {
        for (const SphereInstance& instance : scene_.spheres)
            if (math::distance(camera.lookFrom, instance.sphere.center) <
                static_cast<double>(instance.sphere.radius))
                note(fmt::format("camera '{}' is inside '{}'", camera.name, instance.name));
        if (camera.lens && camera.lens->focusDistance <= camera.lens->focalLength)
            warn(fmt::format(
                "camera '{}': a lens cannot focus at or within its focal_length; increase focus_distance",
                camera.name));
    }

    const SceneDescription& scene_;
    const LoadControl& control_;
    Diagnostics found_;
};

}  // namespace

Diagnostics scene::missingContent(const SceneDescription& scene) {
    Diagnostics found;
    const auto warn = [&](std::string message) {
        found.push_back({Severity::Warning, std::move(message), {scene.path}});
    };
    if (scene.lights.empty())
        warn(
            "no light: surfaces are black unless shading is off; add [[light]] with type = \"point\" and a "
            "position");
    if (scene.meshes.empty() && scene.spheres.empty()) warn("no geometry: add [[mesh]] or [[sphere]]");
    return found;
}

Diagnostics lint(const SceneDescription& scene, const Diagnostics& known, const LoadControl& control) {
    checkDescription(scene);
    Diagnostics found = Linter(scene, control).run();
    std::erase_if(found, [&](const Diagnostic& one) {
        return std::any_of(known.begin(), known.end(), [&](const Diagnostic& other) {
            return one.message == other.message && one.position.file == other.position.file;
        });
    });
    return found;
}

}  // namespace rayscope
