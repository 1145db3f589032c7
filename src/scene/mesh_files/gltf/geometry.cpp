#include "scene/mesh_files/gltf/geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "math/vectors.h"

namespace rayscope::scene {

namespace {

constexpr std::uint64_t kTriangles = 4, kStrip = 5, kFan = 6;  // values of the format

bool isDrawn(const GltfPrimitive& primitive) {
    return primitive.mode >= kTriangles && primitive.attributes.contains("POSITION");
}

glm::dvec2 transformed(const GltfTextureTransform& t, glm::dvec2 uv) {
    uv *= t.scale;
    const double c = std::cos(t.rotation), s = std::sin(t.rotation);
    return glm::dvec2(c * uv.x + s * uv.y, c * uv.y - s * uv.x) + t.offset;
}

/// The corners of triangle i of a list, strip or fan, as numbers of its indices.
glm::uvec3 cornersOf(std::uint64_t mode, std::uint32_t i) {
    if (mode == kStrip) return {i, i + 1 + i % 2, i + 2 - i % 2};
    if (mode == kFan) return {i + 1, i + 2, 0};
    return {3 * i, 3 * i + 1, 3 * i + 2};
}

/// The elements of the corners of the triangles, one after another.
std::vector<float> gathered(const std::vector<float>& values, std::size_t components,
                            std::span<const glm::uvec3> triangles) {
    std::vector<float> result;
    if (values.empty()) return result;
    result.reserve(triangles.size() * 3 * components);
    for (const glm::uvec3& t : triangles)
        for (const std::size_t vertex : {t.x, t.y, t.z})
            for (std::size_t c = 0; c < components; ++c) result.push_back(values[vertex * components + c]);
    return result;
}

}  // namespace

GltfGeometry::GltfGeometry(const std::string& path, const GltfDocument& document,
                           GltfAccessorReader& accessors, const std::vector<GltfPlacement>& placed,
                           bool withColors, Oddities& oddities)
    : path_(path),
      document_(document),
      accessors_(accessors),
      reader_(path, document, accessors, oddities),
      oddities_(oddities) {
    for (const GltfPlacement& placement : placed)
        for (const GltfPrimitive& primitive : document.meshes[placement.index].primitives) {
            if (!isDrawn(primitive)) continue;
            hasNormals_ |= primitive.attributes.contains("NORMAL");
            hasTexCoords_ |= reader_.texCoordsOf(primitive).has_value();
            hasColors_ |= primitive.attributes.contains("COLOR_0");
        }
    if (hasColors_ && !withColors) oddities_.add(Severity::Note, kColorsNotShown);
    hasColors_ &= withColors;
}

std::vector<glm::uvec3> GltfGeometry::readTriangles(const GltfPrimitive& primitive, std::size_t vertices) {
    std::vector<std::uint32_t> indices;
    if (primitive.indices) indices = accessors_.indices(*primitive.indices);
    const std::size_t count = primitive.indices ? indices.size() : vertices;
    checkRange(count);
    const bool isList = primitive.mode == kTriangles;
    if (isList && count % 3 != 0)
        oddities_.add(Severity::Warning, "triangles whose last one has fewer than three corners; left out");
    std::vector<glm::uvec3> triangles;
    const std::size_t number = isList ? count / 3 : std::max<std::size_t>(count, 2) - 2;
    triangles.reserve(number);
    for (std::size_t i = 0; i < number; ++i) {
        glm::uvec3 t = cornersOf(primitive.mode, static_cast<std::uint32_t>(i));
        if (primitive.indices) t = {indices[t.x], indices[t.y], indices[t.z]};
        if (std::max({t.x, t.y, t.z}) >= vertices) {
            oddities_.add(Severity::Warning, "triangles with vertices that do not exist; left out");
            continue;
        }
        // Strips are joined by triangles without area.
        if (!isList && (t.x == t.y || t.y == t.z || t.x == t.z)) continue;
        triangles.push_back(t);
    }
    return triangles;
}

void GltfGeometry::checkRange(std::size_t count) const {
    if (count > std::numeric_limits<std::uint32_t>::max())
        throw InputError("more than 2^32 vertices or triangles", {path_});
}

void GltfGeometry::add(const GltfPrimitive& primitive, const std::vector<double>& weights,
                       const std::vector<glm::dmat4>& joints, const std::vector<glm::dmat4>& toScene) {
    if (primitive.mode < kTriangles) {
        oddities_.add(Severity::Note, primitive.mode == 0 ? "points; ignored" : "lines; ignored");
        return;
    }
    if (!isDrawn(primitive)) {
        oddities_.add(Severity::Note, "primitives without positions; ignored");
        return;
    }
    GltfVertices vertices = reader_.read(primitive, weights, hasColors_);
    std::vector<glm::uvec3> triangles = readTriangles(primitive, vertices.count);
    const bool isSkinned = !joints.empty() && reader_.applySkin(vertices, primitive, joints);
    if (isSkinned && mirrors(glm::dmat3(joints.front())))
        for (glm::uvec3& t : triangles) std::swap(t.y, t.z);
    const bool isFlat = hasNormals_ && vertices.normals.empty();
    checkRange(isFlat ? 3 * triangles.size() : vertices.count);
    if (isFlat) separateFaces(vertices, triangles);
    for (const glm::dmat4& matrix : toScene)
        append(primitive, vertices, triangles, isSkinned ? glm::dmat4(1.0) : matrix, isFlat);
}

void GltfGeometry::append(const GltfPrimitive& primitive, const GltfVertices& vertices,
                          std::span<const glm::uvec3> triangles, const glm::dmat4& toScene, bool isFlat) {
    const std::size_t firstVertex = mesh_.positions.size(), firstTriangle = mesh_.triangles.size();
    checkRange(firstVertex + vertices.count);
    checkRange(firstTriangle + triangles.size());
    appendVertices(primitive, vertices, toScene);
    const bool flips = mirrors(glm::dmat3(toScene));
    const auto base = static_cast<std::uint32_t>(firstVertex);
    for (const glm::uvec3& t : triangles)
        mesh_.triangles.push_back(base + (flips ? glm::uvec3(t.x, t.z, t.y) : t));
    if (hasNormals_ && !isFlat) repairNormals(firstVertex, firstTriangle);
    appendSlot(primitive.material, mesh_.triangles.size() - firstTriangle);
}

void GltfGeometry::appendVertices(const GltfPrimitive& primitive, const GltfVertices& vertices,
                                  const glm::dmat4& toScene) {
    const std::size_t end = mesh_.positions.size() + vertices.count;
    const glm::dmat3 normalMap = normalMapOf(glm::dmat3(toScene));
    for (std::size_t i = 0; i < vertices.count; ++i) {
        const glm::vec3 position(toScene * glm::dvec4(vectorAt(vertices.positions, i), 1.0));
        if (!math::isFinite(position))
            oddities_.add(Severity::Note,
                          "vertices with NaN or infinite coordinates; rays never hit their triangles");
        mesh_.positions.push_back(position);
    }
    if (hasNormals_) {
        mesh_.normals.resize(end, glm::vec3(0.0f));
        for (std::size_t i = 0; i < vertices.normals.size() / 3; ++i)
            mesh_.normals[end - vertices.count + i] =
                glm::vec3(unitOrZero(normalMap * vectorAt(vertices.normals, i)));
    }
    if (hasTexCoords_) appendTexCoords(primitive, vertices.texCoords, vertices.count);
    if (hasColors_) {
        mesh_.colors.resize(end, Rgb(1.0f));
        for (std::size_t i = 0; i < vertices.colors.size() / vertices.colorComponents; ++i) {
            const float* color = &vertices.colors[i * vertices.colorComponents];
            const Rgb stored(color[0], color[1], color[2]);
            // Written so that NaN becomes 0.
            const Rgb clamped(
                glm::mix(Rgb(0.0f), glm::min(stored, Rgb(1.0f)), glm::greaterThan(stored, Rgb(0.0f))));
            if (stored != clamped)
                oddities_.add(Severity::Warning, "vertex colours outside of their range; clamped");
            mesh_.colors[end - vertices.count + i] = clamped;
        }
    }
}

void GltfGeometry::appendTexCoords(const GltfPrimitive& primitive, const std::vector<float>& texCoords,
                                   std::size_t count) {
    const auto* material = primitive.material ? &document_.materials[*primitive.material] : nullptr;
    const bool isTextured = material && material->baseColorTexture;
    if (isTextured && texCoords.empty())
        oddities_.add(Severity::Warning, "textured primitives without texture coordinates; (0, 0) is used");
    for (std::size_t i = 0; i < count; ++i) {
        glm::dvec2 uv =
            texCoords.empty() ? glm::dvec2(0.0) : glm::dvec2(texCoords[2 * i], texCoords[2 * i + 1]);
        if (isTextured && material->baseColorTexture->transform)
            uv = transformed(*material->baseColorTexture->transform, uv);
        // The origin of the format is the upper left corner of the image.
        mesh_.texCoords.emplace_back(uv.x, 1.0 - uv.y);
    }
}

/// Gives each face its own vertices with its normal: the format shades primitives without normals flat.
void GltfGeometry::separateFaces(GltfVertices& vertices, std::vector<glm::uvec3>& triangles) {
    vertices.positions = gathered(vertices.positions, 3, triangles);
    vertices.texCoords = gathered(vertices.texCoords, 2, triangles);
    vertices.colors = gathered(vertices.colors, vertices.colorComponents, triangles);
    vertices.count = triangles.size() * 3;
    vertices.normals.clear();
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        triangles[i] = {3 * i, 3 * i + 1, 3 * i + 2};
        const glm::dvec3 a = vectorAt(vertices.positions, 3 * i), b = vectorAt(vertices.positions, 3 * i + 1);
        const glm::dvec3 normal = unitOrZero(glm::cross(b - a, vectorAt(vertices.positions, 3 * i + 2) - a));
        for (int corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis) vertices.normals.push_back(static_cast<float>(normal[axis]));
    }
}

/// Replaces normals without a direction by the mean of their faces, weighted by area.
void GltfGeometry::repairNormals(std::size_t firstVertex, std::size_t firstTriangle) {
    const std::span normals = std::span(mesh_.normals).subspan(firstVertex);
    const auto isMissing = [](const glm::vec3& n) { return n == glm::vec3(0.0f); };
    if (std::none_of(normals.begin(), normals.end(), isMissing)) return;
    std::vector<glm::dvec3> sums(normals.size(), glm::dvec3(0.0));
    for (const glm::uvec3& t : std::span(mesh_.triangles).subspan(firstTriangle)) {
        const glm::dvec3 a(mesh_.positions[t.x]), b(mesh_.positions[t.y]), c(mesh_.positions[t.z]);
        for (const std::uint32_t vertex : {t.x, t.y, t.z})
            sums[vertex - firstVertex] += glm::cross(b - a, c - a);
    }
    for (std::size_t i = 0; i < normals.size(); ++i) {
        if (!isMissing(normals[i])) continue;
        normals[i] = glm::vec3(unitOrZero(sums[i]));
        oddities_.add(Severity::Warning, "normals that are zero, NaN or infinite; computed from the faces");
    }
}

void GltfGeometry::appendSlot(GltfIndex material, std::size_t count) {
    constexpr std::size_t kMaxSlots = std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1;
    const std::int64_t key = material ? std::int64_t{*material} : -1;
    const auto [entry, isNew] = slotOf_.try_emplace(key, static_cast<std::uint16_t>(slots_.size()));
    if (isNew) {
        if (slots_.size() >= kMaxSlots)
            throw InputError(fmt::format("more than {} materials", kMaxSlots), {path_});
        slots_.push_back(material);
    }
    mesh_.materialSlots.insert(mesh_.materialSlots.end(), count, entry->second);
}

void GltfGeometry::multiplyColors(const std::vector<Material>& materials) {
    if (!hasColors_) return;
    std::vector<bool> isDone(mesh_.positions.size(), false);
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
        const Material& material = materials[mesh_.materialSlots[i]];
        const glm::uvec3& t = mesh_.triangles[i];
        for (const std::uint32_t vertex : {t.x, t.y, t.z}) {
            if (!material.kdTexture && !isDone[vertex]) mesh_.colors[vertex] *= material.kd;
            isDone[vertex] = true;
        }
    }
}

MeshData GltfGeometry::take() {
    if (slots_.size() == 1) mesh_.materialSlots.clear();
    return std::move(mesh_);
}

}  // namespace rayscope::scene
