#include "scene/lint_range.h"

#include "math/vectors.h"
#include "scene/load_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rayscope::scene {

namespace {

float largestOf(const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The distance between adjacent floats near x.
double spacingAt(float x) {
    const float above = std::nextafter(std::abs(x), std::numeric_limits<float>::infinity());
    return static_cast<double>(above) - static_cast<double>(std::abs(x));
}

/// Shapes smaller than this many float steps are dominated by rounding.
constexpr double kMinSteps = 4.0;

class RangeLinter {
  public:
    RangeLinter(const SceneDescription& scene, const LoadControl& control)
        : scene_(scene), control_(control) {}

    Diagnostics run() {
        for (const MeshInstance& mesh : scene_.meshes) lintMesh(mesh);
        for (const SphereInstance& sphere : scene_.spheres) lintSphere(sphere);
        if (!scene_.meshes.empty() || !scene_.spheres.empty()) lintExtent();
        return std::move(found_);
    }

  private:
    void warn(std::string message) {
        found_.push_back({Severity::Warning, std::move(message), {scene_.path}});
    }

    void lintMesh(const MeshInstance& mesh) {
        const glm::dmat4 matrix = matrixOf(mesh.transform);
        std::vector<glm::vec3> transformed;
        transformed.reserve(mesh.data->positions.size());
        LoadStep step(control_, fmt::format("checking the size of mesh '{}'", mesh.name),
                      mesh.data->positions.size() + mesh.data->triangles.size());
        std::size_t overflowing = 0;
        float largest = 0.0f;
        for (const glm::vec3& p : mesh.data->positions) {
            step.advance();
            transformed.emplace_back(matrix * glm::dvec4(glm::dvec3(p), 1.0));
            overflowing += math::isFinite(p) && !math::isFinite(transformed.back());
            if (math::isFinite(transformed.back()))
                largest = std::max(largest, largestOf(transformed.back()));
        }
        if (overflowing > 0)
            warn(
                fmt::format("mesh '{}': {} vertices overflow float after the transform; rays never hit their "
                            "triangles",
                            mesh.name, overflowing));
        std::size_t coarse = 0;
        for (const glm::uvec3& t : mesh.data->triangles) {
            step.advance();
            coarse += isCoarse(mesh.data->positions, transformed, t);
        }
        if (coarse > 0)
            warn(fmt::format(
                "mesh '{}': {} of {} triangles have edges shorter than {:g} float steps, which are up to "
                "{:.3g} units there; rounding dominates their shape; move the mesh closer to the origin or "
                "enlarge it",
                mesh.name, coarse, mesh.data->triangles.size(), kMinSteps, spacingAt(largest)));
    }

    /// Whether a triangle with three distinct vertices has an edge of less than kMinSteps after the
    /// transform.
    static bool isCoarse(const std::vector<glm::vec3>& given, const std::vector<glm::vec3>& transformed,
                         const glm::uvec3& t) {
        for (int k = 0; k < 3; ++k) {
            const unsigned a = t[k], b = t[(k + 1) % 3];
            if (!math::isFinite(transformed[a]) || !math::isFinite(transformed[b]) || given[a] == given[b])
                return false;
        }
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 a = transformed[t[k]], b = transformed[t[(k + 1) % 3]];
            const double edge = glm::length(glm::dvec3(b) - glm::dvec3(a));
            if (edge < kMinSteps * spacingAt(std::max(largestOf(a), largestOf(b)))) return true;
        }
        return false;
    }

    void lintSphere(const SphereInstance& instance) {
        const Sphere& sphere = instance.sphere;
        const double spacing = spacingAt(largestOf(sphere.center));
        if (sphere.radius > 0.0f && static_cast<double>(sphere.radius) < kMinSteps * spacing)
            warn(fmt::format(
                "sphere '{}': its radius {:.3g} is less than {:g} float steps of {:.3g} units at its "
                "centre; move it closer to the origin or enlarge it",
                instance.name, sphere.radius, kMinSteps, spacing));
    }

    void lintExtent() {
        const SceneBounds bounds = boundsOf(scene_, control_);
        const glm::dvec3 lower(bounds.lower), upper(bounds.upper);
        const double size = glm::length(upper - lower), distance = glm::length(0.5 * (lower + upper));
        if (!(size >= kMinSceneSize) || !(size <= kMaxSceneSize))
            warn(fmt::format(
                "the scene has a size of {:.3g}; hits are proven correct from {:.2g} to {:.2g}; scale it by "
                "{:.0e}",
                size, kMinSceneSize, kMaxSceneSize, size > 0.0 ? 1.0 / size : 1.0 / kMinSceneSize));
        else if (distance > kMaxRelativeDistance * size)
            warn(fmt::format(
                "the scene has a size of {:.3g} and a distance of {:.3g} from the origin, {:.2g} times its "
                "size; hits are proven correct up to {:.0e} times; move it closer",
                size, distance, distance / size, kMaxRelativeDistance));
    }

    const SceneDescription& scene_;
    const LoadControl& control_;
    Diagnostics found_;
};

}  // namespace

Diagnostics lintRange(const SceneDescription& scene, const LoadControl& control) {
    return RangeLinter(scene, control).run();
}

}  // namespace rayscope::scene
