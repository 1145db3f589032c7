#include "viewer/view/simplify_mesh.h"

#include "math/vectors.h"

#include <rayscope/diagnostics.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace rayscope::viewer {

namespace {

constexpr double kMaxCells = 1024.0;  // along the longest side
constexpr std::uint64_t kNoCell = ~std::uint64_t{0};

struct Extent {
    glm::dvec3 lower{0.0};
    double longest = 0.0;
};

Extent extentOf(const std::vector<glm::vec3>& positions) {
    glm::dvec3 lower(std::numeric_limits<double>::infinity()), upper(-lower);
    for (const glm::vec3& position : positions) {
        if (!math::isFinite(position)) continue;
        lower = glm::min(lower, glm::dvec3(position));
        upper = glm::max(upper, glm::dvec3(position));
    }
    const glm::dvec3 size = upper - lower;
    return {lower, std::max({size.x, size.y, size.z, 0.0})};
}

/// The index of the cell of each vertex.
std::vector<std::uint64_t> cellsOf(const std::vector<glm::vec3>& positions, const Extent& extent,
                                   double cells) {
    const double scale = extent.longest > 0.0 ? cells / extent.longest : 0.0;
    std::vector<std::uint64_t> numbers;
    numbers.reserve(positions.size());
    for (const glm::vec3& position : positions) {
        const glm::dvec3 cell = (glm::dvec3(position) - extent.lower) * scale;
        const auto axis = [&](double value) { return static_cast<std::uint64_t>(value); };
        numbers.push_back(math::isFinite(position) ? axis(cell.x) << 42 | axis(cell.y) << 21 | axis(cell.z)
                                                   : kNoCell);
    }
    return numbers;
}

bool keepsItsCorners(glm::uvec3 triangle, const std::vector<std::uint64_t>& cells) {
    const std::uint64_t a = cells[triangle.x], b = cells[triangle.y], c = cells[triangle.z];
    return a != b && b != c && c != a && a != kNoCell && b != kNoCell && c != kNoCell;
}

/// The finest grid that leaves few enough triangles.
std::vector<std::uint64_t> finestCells(const MeshData& mesh, std::size_t maxTriangles,
                                       const std::stop_token& stop) {
    const Extent extent = extentOf(mesh.positions);
    for (double count = kMaxCells;; count = std::floor(count)) {
        if (stop.stop_requested()) throw Stopped();
        std::vector<std::uint64_t> cells = cellsOf(mesh.positions, extent, count);
        const auto left = static_cast<std::size_t>(
            std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                          [&](glm::uvec3 triangle) { return keepsItsCorners(triangle, cells); }));
        if (left <= maxTriangles || count <= 1.0) return cells;
        // The number of triangles of a surface grows with the square of the number of cells.
        const double shrink = std::sqrt(static_cast<double>(maxTriangles) / static_cast<double>(left));
        count = std::max(1.0, count * std::clamp(shrink, 0.5, 0.95));
    }
}

/// One vertex per cell, at the mean of its vertices; texture coordinates and colour are those of the first.
MeshData clustered(const MeshData& mesh, const std::vector<std::uint64_t>& cells) {
    MeshData coarse;
    std::unordered_map<std::uint64_t, std::uint32_t> vertexOfCell;
    std::vector<float> members;
    std::vector<std::uint32_t> vertexOf(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (cells[i] == kNoCell) continue;
        const auto [entry, isNew] =
            vertexOfCell.try_emplace(cells[i], static_cast<std::uint32_t>(members.size()));
        const std::uint32_t vertex = vertexOf[i] = entry->second;
        if (isNew) {
            members.push_back(0.0f);
            coarse.positions.emplace_back(0.0f);
            if (!mesh.normals.empty()) coarse.normals.emplace_back(0.0f);
            if (!mesh.texCoords.empty()) coarse.texCoords.push_back(mesh.texCoords[i]);
            if (!mesh.colors.empty()) coarse.colors.push_back(mesh.colors[i]);
        }
        members[vertex] += 1.0f;
        coarse.positions[vertex] += (mesh.positions[i] - coarse.positions[vertex]) / members[vertex];
        if (!mesh.normals.empty()) coarse.normals[vertex] += mesh.normals[i];
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 triangle = mesh.triangles[i];
        if (!keepsItsCorners(triangle, cells)) continue;
        coarse.triangles.emplace_back(vertexOf[triangle.x], vertexOf[triangle.y], vertexOf[triangle.z]);
        if (!mesh.materialSlots.empty()) coarse.materialSlots.push_back(mesh.materialSlots[i]);
    }
    return coarse;
}

/// `count` of the triangles, evenly spaced in the list.
MeshData someTriangles(const MeshData& mesh, std::size_t count) {
    MeshData some{mesh.positions, mesh.normals, mesh.texCoords, mesh.colors, {}, {}};
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = k * mesh.triangles.size() / count;
        some.triangles.push_back(mesh.triangles[i]);
        if (!mesh.materialSlots.empty()) some.materialSlots.push_back(mesh.materialSlots[i]);
    }
    return some;
}

double areaOf(const MeshData& mesh) {
    double twice = 0.0;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[triangle.x]), b(mesh.positions[triangle.y]),
            c(mesh.positions[triangle.z]);
        const double area = glm::length(glm::cross(b - a, c - a));
        if (std::isfinite(area)) twice += area;
    }
    return 0.5 * twice;
}

}  // namespace

MeshData simplifyMesh(const MeshData& mesh, std::size_t maxTriangles, std::stop_token stop) {
    if (mesh.triangles.size() <= maxTriangles) return mesh;
    MeshData coarse = clustered(mesh, finestCells(mesh, maxTriangles, stop));
    constexpr double kVanishing = 0.5;  // of the area
    if (areaOf(coarse) < kVanishing * areaOf(mesh)) return someTriangles(mesh, maxTriangles);
    return coarse;
}

}  // namespace rayscope::viewer
