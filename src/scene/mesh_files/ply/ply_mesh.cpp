#include "scene/mesh_files/ply/ply_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "image/srgb.h"
#include "scene/load_step.h"
#include "scene/mesh_files/geometry/triangulate.h"

namespace rayscope::scene {

namespace {

/// Whether triangulate() makes the triangles 0 1 2 and 0 2 3 of a quadrilateral, because it is convex.
bool isConvexQuad(const std::array<glm::vec3, 4>& points) {
    glm::dvec3 corner[4], normal(0.0);
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3 before(points[static_cast<std::size_t>((i + 3) % 4)]),
            here(points[static_cast<std::size_t>(i)]), after(points[static_cast<std::size_t>((i + 1) % 4)]);
        corner[i] = glm::cross(here - before, after - here);
        normal += corner[i];
    }
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    for (int i = 0; i < 4; ++i)
        if (!(corner[i][axis] * normal[axis] > 0.0)) return false;
    return true;
}

/// A value of 0 … `largest` in sRGB as a linear one; `inRange` becomes false for others, which are clamped.
float decodeColor(float value, float largest, bool& inRange) {
    const float fraction = value / largest;
    if (!(fraction >= 0.0f && fraction <= 1.0f)) {
        inRange = false;
        return fraction > 1.0f ? 1.0f : 0.0f;
    }
    if (largest != 255.0f || value != std::floor(value)) return image::srgbToLinear(fraction);
    return image::decodeByte(static_cast<std::uint8_t>(value));
}

}  // namespace

PlyMesh::PlyMesh(const PlyPlan& plan, Oddities& oddities, const LoadControl& control)
    : plan_(plan), oddities_(oddities), control_(control), vertexCount_(plan.vertexCount()) {}

void PlyMesh::reserve(std::uint64_t vertices, std::uint64_t triangles) {
    const auto count = static_cast<std::size_t>(vertices);
    mesh_.positions.reserve(count);
    if (plan_.hasNormals) mesh_.normals.reserve(count);
    if (plan_.hasTexCoords) mesh_.texCoords.reserve(count);
    if (plan_.hasColors) mesh_.colors.reserve(count);
    mesh_.triangles.reserve(static_cast<std::size_t>(triangles));
}

void PlyMesh::addVertices(const PlyVertices& rows) {
    const auto column = [&](PlyRole role) -> const auto& {
        return rows.columns[static_cast<std::size_t>(role)];
    };
    const std::size_t first = mesh_.positions.size();
    const auto appendVectors = [&](std::vector<glm::vec3>& to, PlyRole role) {
        const auto &x = column(role), &y = rows.columns[static_cast<std::size_t>(role) + 1],
                   &z = rows.columns[static_cast<std::size_t>(role) + 2];
        to.resize(first + rows.count);
        for (std::size_t i = 0; i < rows.count; ++i) to[first + i] = {x[i], y[i], z[i]};
    };
    appendVectors(mesh_.positions, PlyRole::X);
    if (plan_.hasNormals) appendVectors(mesh_.normals, PlyRole::Nx);
    if (plan_.hasTexCoords)
        for (std::size_t i = 0; i < rows.count; ++i)
            mesh_.texCoords.emplace_back(column(PlyRole::U)[i], column(PlyRole::V)[i]);
    if (plan_.hasColors) addColors(rows, first);
    for (std::size_t i = 0; i < rows.count; ++i) {
        const glm::vec3& p = mesh_.positions[first + i];
        // The difference is 0 for finite numbers, and NaN for others.
        if (p.x - p.x + (p.y - p.y) + (p.z - p.z) != 0.0f)
            oddities_.add(Severity::Note,
                          "vertices with NaN or infinite coordinates; rays never hit their triangles",
                          rows.lines[i]);
    }
}

void PlyMesh::addColors(const PlyVertices& rows, std::size_t first) {
    mesh_.colors.resize(first + rows.count);
    for (std::size_t i = 0; i < rows.count; ++i) {
        bool inRange = true;
        for (std::size_t channel = 0; channel < 3; ++channel)
            mesh_.colors[first + i][static_cast<int>(channel)] =
                decodeColor(rows.columns[static_cast<std::size_t>(PlyRole::R) + channel][i],
                            plan_.largestColor[channel], inRange);
        if (!inRange)
            oddities_.add(Severity::Warning, "vertex colours outside of their range; clamped", rows.lines[i]);
    }
}

const std::int64_t* PlyMesh::addFace(const PlyFace& face) {
    const std::vector<std::int64_t>& corners = face.corners;
    for (const std::int64_t& index : corners)
        if (!isVertex(index)) return &index;
    if (corners.size() < 3) {
        oddities_.add(Severity::Note, "faces with fewer than three corners; ignored", face.line);
        return nullptr;
    }
    ring_.resize(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) ring_[i] = cornerOf(face, i);
    if (plan_.hasCornerTexCoords && face.texCoords.size() != 2 * corners.size())
        oddities_.add(Severity::Warning,
                      "faces whose list 'texcoord' does not have two numbers per corner; 0 is used",
                      face.line);
    const Polygon polygon{mesh_.triangles.size(), static_cast<std::uint32_t>(corners.size()), face.line};
    for (std::size_t i = 1; i + 1 < ring_.size(); ++i)
        mesh_.triangles.emplace_back(ring_[0], ring_[i], ring_[i + 1]);
    addSlots(face.textureNumber, corners.size() - 2, face.line);
    if (corners.size() == 3) return nullptr;
    if (mesh_.positions.size() == vertexCount_)
        triangulateFan(polygon);
    else
        polygons_.push_back(polygon);
    return nullptr;
}

/// The index in the mesh of a corner of a face.
std::uint32_t PlyMesh::cornerOf(const PlyFace& face, std::size_t i) {
    if (face.texCoords.size() != 2 * face.corners.size()) return cornerAt(face.corners[i], glm::vec2(0.0f));
    return cornerAt(face.corners[i], {face.texCoords[2 * i], face.texCoords[2 * i + 1]});
}

std::uint32_t PlyMesh::cornerAt(std::int64_t vertex, const glm::vec2& uv) {
    if (!plan_.hasCornerTexCoords) return static_cast<std::uint32_t>(vertex);
    return corners_.indexOf({static_cast<std::int32_t>(vertex), std::bit_cast<std::int32_t>(uv.x),
                             std::bit_cast<std::int32_t>(uv.y)});
}

void PlyMesh::addSlots(std::int64_t number, std::size_t triangles, int line) {
    if (!plan_.hasTextureNumbers) return;
    const std::size_t textures = std::min<std::size_t>(plan_.header.textureFiles.size(), 0x10000);
    const bool exists = static_cast<std::uint64_t>(number) < textures;
    if (!exists)
        oddities_.add(Severity::Warning, "faces whose 'texnumber' has no TextureFile; the first is used",
                      line);
    mesh_.materialSlots.insert(mesh_.materialSlots.end(), triangles,
                               static_cast<std::uint16_t>(exists ? number : 0));
}

/// Every corner after the second makes a triangle with the two before it; -1 ends the strip. Every second
/// triangle is turned over, and triangles with equal corners are stitches.
const std::int64_t* PlyMesh::addStripCorners(std::span<const std::int64_t> corners) {
    for (const std::int64_t& index : corners) {
        if (index == -1) {
            stripLength_ = 0;
            continue;
        }
        if (!isVertex(index)) return &index;
        const std::uint32_t corner = cornerAt(index, glm::vec2(0.0f));
        const auto [a, b] = stripEnd_;
        if (stripLength_ >= 2 && a != b && b != corner && corner != a) {
            mesh_.triangles.push_back(stripLength_ % 2 == 0 ? glm::uvec3(a, b, corner)
                                                            : glm::uvec3(b, a, corner));
            addSlots(0, 1, 0);
        }
        stripEnd_ = {b, corner};
        ++stripLength_;
    }
    return nullptr;
}

const glm::vec3& PlyMesh::positionOf(std::uint32_t corner) const {
    return mesh_
        .positions[plan_.hasCornerTexCoords ? static_cast<std::size_t>(corners_.corners()[corner].position)
                                            : corner];
}

/// Replaces the fan of a polygon by its triangulation.
void PlyMesh::triangulateFan(const Polygon& polygon) {
    glm::uvec3* const fan = &mesh_.triangles[polygon.firstTriangle];
    if (polygon.corners == 4 && isConvexQuad({positionOf(fan[0].x), positionOf(fan[0].y),
                                              positionOf(fan[0].z), positionOf(fan[1].z)}))
        return;
    ring_ = {fan[0].x, fan[0].y};
    for (std::uint32_t i = 0; i + 2 < polygon.corners; ++i) ring_.push_back(fan[i].z);
    points_.clear();
    for (const std::uint32_t corner : ring_) points_.push_back(positionOf(corner));
    triangles_.resize(polygon.corners - 2);
    if (!triangulate(points_, triangles_)) oddities_.add(Severity::Warning, kCrossingOutline, polygon.line);
    for (std::size_t i = 0; i < triangles_.size(); ++i)
        fan[i] = {ring_[triangles_[i].x], ring_[triangles_[i].y], ring_[triangles_[i].z]};
}

/// Gives each pair of a vertex and texture coordinates a vertex of its own.
void PlyMesh::splitVertices() {
    const std::vector<Corner>& corners = corners_.corners();
    const auto gather = [&](auto& values) {
        if (values.empty()) return;
        std::remove_reference_t<decltype(values)> split;
        split.reserve(corners.size());
        for (const Corner& corner : corners)
            split.push_back(values[static_cast<std::size_t>(corner.position)]);
        values = std::move(split);
    };
    gather(mesh_.positions);
    gather(mesh_.normals);
    gather(mesh_.colors);
    mesh_.texCoords.clear();
    mesh_.texCoords.reserve(corners.size());
    for (const Corner& corner : corners)
        mesh_.texCoords.emplace_back(std::bit_cast<float>(corner.texCoord),
                                     std::bit_cast<float>(corner.normal));
}

MeshData PlyMesh::finish(const std::string& path) {
    if (!polygons_.empty()) {
        LoadStep step(control_, "triangulating " + path.substr(path.find_last_of('/') + 1), polygons_.size());
        for (const Polygon& polygon : polygons_) {
            triangulateFan(polygon);
            step.advance();
        }
    }
    if (mesh_.triangles.empty()) throw InputError("no face has three or more corners", {path});
    if (plan_.hasCornerTexCoords) splitVertices();
    return std::move(mesh_);
}

}  // namespace rayscope::scene
