#include "measure/lab/lab_mesh.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "math/vectors.h"
#include "trace/motion_group.h"

namespace rayscope::measure {

namespace {

/// In double: neither two equal vertices nor three on a line.
bool hasArea(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 ab = glm::dvec3(b) - glm::dvec3(a), ac = glm::dvec3(c) - glm::dvec3(a);
    return glm::cross(ab, ac) != glm::dvec3(0.0);
}

/// Parallel to no axis and no diagonal.
glm::dvec3 offsetDirection() { return glm::normalize(glm::dvec3(1.0, -0.83, 0.57)); }

}  // namespace

LabMesh::LabMesh(const SceneDescription& scene) {
    const auto motionGroups = trace::makeGeometry(scene, false);
    if (!motionGroups.empty()) weld(motionGroups[0]->input.vertices, motionGroups[0]->input.triangles);
    findEdges();
    findVertexTriangles();
    glm::dvec3 lower(HUGE_VAL), upper(-HUGE_VAL);
    for (const glm::vec3& v : vertices_) {
        lower = glm::min(lower, glm::dvec3(v));
        upper = glm::max(upper, glm::dvec3(v));
    }
    if (vertices_.empty()) return;
    center_ = 0.5 * (lower + upper);
    size_ = glm::length(upper - lower);
}

/// Merges equal vertices and keeps finite triangles with three different ones.
void LabMesh::weld(std::span<const glm::vec3> vertices, std::span<const glm::uvec3> triangles) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < vertices.size(); ++i)
        if (math::isFinite(vertices[i])) order.push_back(i);
    const auto key = [&](std::uint32_t i) { return std::tuple(vertices[i].x, vertices[i].y, vertices[i].z); };
    std::sort(order.begin(), order.end(), [&](auto i, auto j) { return key(i) < key(j); });
    constexpr std::uint32_t kNone = ~0u;
    std::vector<std::uint32_t> merged(vertices.size(), kNone);
    for (const std::uint32_t i : order) {
        if (vertices_.empty() || vertices_.back() != vertices[i]) vertices_.push_back(vertices[i]);
        merged[i] = static_cast<std::uint32_t>(vertices_.size() - 1);
    }
    for (const glm::uvec3& t : triangles) {
        const glm::uvec3 w(merged[t.x], merged[t.y], merged[t.z]);
        const bool kept = w.x != kNone && w.y != kNone && w.z != kNone;
        if (kept && w.x != w.y && w.y != w.z && w.z != w.x) triangles_.push_back(w);
    }
}

void LabMesh::findEdges() {
    struct Side {
        std::uint32_t a, b, triangle;
        auto ends() const { return std::pair(a, b); }
    };
    std::vector<Side> sides;
    sides.reserve(3 * triangles_.size());
    for (std::uint32_t i = 0; i < triangles_.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(triangles_[i][k], triangles_[i][(k + 1) % 3]);
            sides.push_back({a, b, i});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
        return std::tuple(x.a, x.b, x.triangle) < std::tuple(y.a, y.b, y.triangle);
    });
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i;
        while (end < sides.size() && sides[end].ends() == sides[i].ends()) ++end;
        if (end - i == 2)
            edges_.push_back({sides[i].a, sides[i].b, {sides[i].triangle, sides[i + 1].triangle}});
        else
            openEdges_.insert(openEdges_.end(), {sides[i].a, sides[i].b});
        i = end;
    }
}

void LabMesh::findVertexTriangles() {
    std::vector<std::uint32_t> next(vertices_.size() + 2, 0);
    for (const glm::uvec3& t : triangles_)
        for (int k = 0; k < 3; ++k) ++next[t[k] + 2];
    for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
    vertexTriangles_.resize(3 * triangles_.size());
    for (std::uint32_t i = 0; i < triangles_.size(); ++i)
        for (int k = 0; k < 3; ++k) vertexTriangles_[next[triangles_[i][k] + 1]++] = i;
    next.pop_back();
    firstTriangle_ = std::move(next);

    std::vector<bool> open(vertices_.size(), false);
    for (const std::uint32_t vertex : openEdges_) open[vertex] = true;
    for (std::uint32_t v = 0; v < vertices_.size(); ++v)
        if (!open[v] && firstTriangle_[v] != firstTriangle_[v + 1]) closed_.push_back(v);
}

std::span<const std::uint32_t> LabMesh::trianglesAround(std::uint32_t vertex) const {
    return std::span(vertexTriangles_)
        .subspan(firstTriangle_[vertex], firstTriangle_[vertex + 1] - firstTriangle_[vertex]);
}

std::vector<glm::vec3> LabMesh::verticesAt(const LabTransform& transform) const {
    std::vector<glm::vec3> transformed;
    transformed.reserve(vertices_.size());
    for (const glm::vec3& v : vertices_) {
        const glm::dvec3 unscaled = glm::dvec3(v) - center_ + transform.offset * size_ * offsetDirection();
        transformed.emplace_back(std::ldexp(1.0, transform.scale) * unscaled);
    }
    return transformed;
}

std::uint64_t LabMesh::degenerate(const std::vector<glm::vec3>& transformed) const {
    std::uint64_t count = 0;
    for (const glm::uvec3& t : triangles_)
        count += hasArea(vertices_[t.x], vertices_[t.y], vertices_[t.z]) &&
                 !hasArea(transformed[t.x], transformed[t.y], transformed[t.z]);
    return count;
}

}  // namespace rayscope::measure

namespace rayscope {

Ray rayInScene(const LabResult& result, const LabFailure& failure) {
    const LabTransform& transform = result.testPoints[failure.testPoint].transform;
    Ray ray = failure.ray;
    ray.origin = glm::vec3(std::ldexp(1.0, -transform.scale) * glm::dvec3(ray.origin) -
                           transform.offset * result.size * measure::offsetDirection() + result.center);
    return ray;
}

MeshData meshAt(const SceneDescription& scene, const LabTransform& transform) {
    const measure::LabMesh mesh(scene);
    return {.positions = mesh.verticesAt(transform), .triangles = mesh.triangles()};
}

}  // namespace rayscope
