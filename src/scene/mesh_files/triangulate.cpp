#include "scene/mesh_files/triangulate.h"

#include <cmath>
#include <numeric>
#include <vector>

namespace rayscope::scene {

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

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
    for (const glm::vec3& p : points) {
        const glm::dvec2 q(p[u], p[v]);
        flat.push_back(normal[drop] < 0.0 ? glm::dvec2(q.y, q.x) : q);
    }
    return flat;
}

bool isEar(const std::vector<glm::dvec2>& flat, const std::vector<std::uint32_t>& ring, std::size_t i) {
    const std::size_t n = ring.size();
    const glm::dvec2 a = flat[ring[(i + n - 1) % n]], b = flat[ring[i]], c = flat[ring[(i + 1) % n]];
    if (cross(b - a, c - b) <= 0.0) return false;
    for (std::size_t k = 0; k < n; ++k) {
        const glm::dvec2 p = flat[ring[k]];
        if (p == a || p == b || p == c) continue;
        if (cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0 && cross(a - c, p - c) >= 0.0)
            return false;
    }
    return true;
}

}  // namespace

void triangulate(std::span<const glm::vec3> points, std::span<glm::uvec3> triangles) {
    std::vector<std::uint32_t> ring(points.size());
    std::iota(ring.begin(), ring.end(), 0u);
    const glm::dvec3 normal = areaVector(points);
    const std::vector<glm::dvec2> flat = project(points, normal);
    std::size_t count = 0;
    bool stuck = !std::isfinite(glm::dot(normal, normal));
    while (ring.size() > 3 && !stuck) {
        stuck = true;
        // Starting at the second corner turns a convex polygon into the usual fan around the first.
        for (std::size_t i = 1; i <= ring.size(); ++i) {
            const std::size_t ear = i % ring.size();
            if (!isEar(flat, ring, ear)) continue;
            const std::size_t n = ring.size();
            triangles[count++] = {ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]};
            ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
            stuck = false;
            break;
        }
    }
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) triangles[count++] = {ring[0], ring[i], ring[i + 1]};
}

}  // namespace rayscope::scene
