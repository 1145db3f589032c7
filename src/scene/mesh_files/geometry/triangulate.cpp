#include "scene/mesh_files/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "scene/mesh_files/geometry/ear_clipper.h"
#include "scene/mesh_files/geometry/orientation.h"

namespace rayscope::scene {

namespace {

/// Twice the area vector of the polygon (Newell's method), along its normal even if it is non-planar or
/// concave.
glm::dvec3 areaVector(std::span<const glm::vec3> points) {
    glm::dvec3 sum(0.0);
    const glm::dvec3 origin(points[0]);
    for (std::size_t i = 0; i < points.size(); ++i)
        sum +=
            glm::cross(glm::dvec3(points[i]) - origin, glm::dvec3(points[(i + 1) % points.size()]) - origin);
    return sum;
}

/// The polygon projected along the axis of the largest component of the normal, counter-clockwise.
std::vector<glm::dvec2> project(std::span<const glm::vec3> points, const glm::dvec3& normal) {
    const glm::dvec3 size = glm::abs(normal);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int u = (drop + 1) % 3, v = (drop + 2) % 3;
    std::vector<glm::dvec2> flat;
    flat.reserve(points.size());
    for (const glm::vec3& p : points) {
        const glm::dvec2 q(p[u], p[v]);
        flat.push_back(normal[drop] < 0.0 ? glm::dvec2(q.y, q.x) : q);
    }
    return flat;
}

/// Whether all corners turn left and the outline goes round once: its edges change their direction along the
/// first axis twice.
bool isStrictlyConvex(const std::vector<glm::dvec2>& flat) {
    const std::size_t n = flat.size();
    const auto goesRight = [&](std::size_t i) {
        const glm::dvec2 a = flat[i % n], b = flat[(i + 1) % n];
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    };
    std::size_t changes = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (orientation(flat[i], flat[(i + 1) % n], flat[(i + 2) % n]) <= 0.0) return false;
        changes += goesRight(i) != goesRight(i + 1);
    }
    return changes == 2;
}

void makeFan(std::span<const std::uint32_t> ring, std::span<glm::uvec3> triangles) {
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) triangles[i - 1] = {ring[0], ring[i], ring[i + 1]};
}

/// Whether a fan has triangles with an area: an outline without area but with such triangles crosses itself.
bool hasArea(std::span<const glm::vec3> points) {
    const glm::dvec3 a(points[0]);
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        if (glm::cross(glm::dvec3(points[i]) - a, glm::dvec3(points[i + 1]) - a) != glm::dvec3(0.0))
            return true;
    return false;
}

/// Whether the outline goes round the same corners again and again: an outline that does not cross itself has
/// most of its corners once, those of bridges twice, and comes back to a corner at most after two others.
bool repeatsCorners(std::vector<glm::dvec2> flat) {
    constexpr std::size_t kFew = 64;
    if (flat.size() <= kFew) return false;
    const auto before = [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    };
    const std::size_t corners = flat.size();
    std::sort(flat.begin(), flat.end(), before);
    const auto distinct = std::unique(flat.begin(), flat.end()) - flat.begin();
    return 4 * static_cast<std::size_t>(distinct) < corners;
}

}  // namespace

bool triangulate(std::span<const glm::vec3> points, std::span<glm::uvec3> triangles,
                 const std::function<void(std::size_t)>& progress) {
    std::vector<std::uint32_t> ring(points.size());
    std::iota(ring.begin(), ring.end(), 0u);
    const glm::dvec3 normal = areaVector(points);
    const bool isFinite = std::isfinite(glm::dot(normal, normal));
    if (!isFinite || normal == glm::dvec3(0.0)) {
        makeFan(ring, triangles);
        return !isFinite || !hasArea(points);
    }
    const std::vector<glm::dvec2> flat = project(points, normal);
    if (isStrictlyConvex(flat)) {
        makeFan(ring, triangles);
        return true;
    }
    if (repeatsCorners(flat)) {
        makeFan(ring, triangles);
        return false;
    }
    return EarClipper(flat).clip(triangles, progress);
}

}  // namespace rayscope::scene
