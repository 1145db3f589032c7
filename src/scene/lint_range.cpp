#include "scene/lint_range.h"

#include "math/vectors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rayscope::scene {

namespace {

float largestOf(const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The distance between neighbouring floats near x.
double spacingAt(float x) {
    const float above = std::nextafter(std::abs(x), std::numeric_limits<float>::infinity());
    return static_cast<double>(above) - static_cast<double>(std::abs(x));
}

/// Fewer steps of float than this across a shape, and its form is mostly rounding.
constexpr double kFewSteps = 4.0;

class RangeLinter {
  public:
    explicit RangeLinter(const SceneDescription& scene) : scene_(scene) {}

    Diagnostics run() {
        for (const MeshInstance& mesh : scene_.meshes) lintMesh(mesh);
        for (const SphereInstance& sphere : scene_.spheres) lintSphere(sphere);
        if (!scene_.meshes.empty() || !scene_.spheres.empty()) lintPlace();
        return std::move(found_);
    }

  private:
    void warn(std::string message) {
        found_.push_back({Severity::Warning, std::move(message), {scene_.path}});
    }

    void lintMesh(const MeshInstance& mesh) {
        const glm::dmat4 matrix = matrixOf(mesh.transform);
        std::vector<glm::vec3> placed;
        placed.reserve(mesh.data->positions.size());
        std::size_t overflowing = 0;
        float largest = 0.0f;
        for (const glm::vec3& p : mesh.data->positions) {
            placed.emplace_back(matrix * glm::dvec4(glm::dvec3(p), 1.0));
            overflowing += math::isFinite(p) && !math::isFinite(placed.back());
            if (math::isFinite(placed.back())) largest = std::max(largest, largestOf(placed.back()));
        }
        if (overflowing > 0)
            warn(
                fmt::format("mesh '{}': {} vertices are too far away for a float where its transform puts "
                            "them; their triangles are never hit",
                            mesh.name, overflowing));
        std::size_t coarse = 0;
        for (const glm::uvec3& t : mesh.data->triangles) coarse += isCoarse(mesh.data->positions, placed, t);
        if (coarse > 0)
            warn(fmt::format(
                "mesh '{}': {} of {} triangles have sides of less than {:g} steps of float, which "
                "are up to {:.3g} units there, so rounding decides their shape; move the mesh "
                "nearer to the origin, or make it larger",
                mesh.name, coarse, mesh.data->triangles.size(), kFewSteps, spacingAt(largest)));
    }

    /// Whether a triangle with three different corners has, once placed, a side of only a few steps.
    static bool isCoarse(const std::vector<glm::vec3>& given, const std::vector<glm::vec3>& placed,
                         const glm::uvec3& t) {
        for (int k = 0; k < 3; ++k) {
            const unsigned a = t[k], b = t[(k + 1) % 3];
            if (!math::isFinite(placed[a]) || !math::isFinite(placed[b]) || given[a] == given[b])
                return false;
        }
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 a = placed[t[k]], b = placed[t[(k + 1) % 3]];
            const double side = glm::length(glm::dvec3(b) - glm::dvec3(a));
            if (side < kFewSteps * spacingAt(std::max(largestOf(a), largestOf(b)))) return true;
        }
        return false;
    }

    void lintSphere(const SphereInstance& instance) {
        const Sphere& sphere = instance.sphere;
        const double spacing = spacingAt(largestOf(sphere.center));
        if (sphere.radius > 0.0f && static_cast<double>(sphere.radius) < kFewSteps * spacing)
            warn(
                fmt::format("sphere '{}': its radius {:.3g} is less than {:g} steps of float at its centre, "
                            "where they are {:.3g} units; move it nearer to the origin, or make it larger",
                            instance.name, sphere.radius, kFewSteps, spacing));
    }

    void lintPlace() {
        const SceneBounds bounds = boundsOf(scene_);
        const glm::dvec3 lower(bounds.lower), upper(bounds.upper);
        const double size = glm::length(upper - lower), away = glm::length(0.5 * (lower + upper));
        if (!(size >= kMinSceneSize) || !(size <= kMaxSceneSize))
            warn(fmt::format(
                "the scene is {:.3g} units large; hits are proven right from {:.2g} to {:.2g}, so scale "
                "it by {:.0e}",
                size, kMinSceneSize, kMaxSceneSize, size > 0.0 ? 1.0 / size : 1.0 / kMinSceneSize));
        else if (away > kMaxRelativeDistance * size)
            warn(fmt::format(
                "the scene is {:.3g} units large and {:.3g} from the origin, {:.2g} times its size; hits "
                "are proven right up to {:.0e} times, so move it nearer",
                size, away, away / size, kMaxRelativeDistance));
    }

    const SceneDescription& scene_;
    Diagnostics found_;
};

}  // namespace

Diagnostics lintRange(const SceneDescription& scene) { return RangeLinter(scene).run(); }

}  // namespace rayscope::scene
