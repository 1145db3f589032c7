#include "viewer/gl/mesh_buffer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viewer/model/projection.h"

namespace rayscope::viewer {

namespace {

template <class T>
void uploadAttribute(GLuint buffer, GLuint index, GLint components, const std::vector<T>& values) {
    if (values.empty()) return;
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, 0, nullptr);
}

/// Of the finite ones; 0 if there is none.
double largestCoordinate(const std::vector<glm::vec3>& positions) {
    float largest = 0.0f;
    for (const glm::vec3& p : positions)
        for (int axis = 0; axis < 3; ++axis)
            if (std::isfinite(p[axis])) largest = std::max(largest, std::abs(p[axis]));
    return static_cast<double>(largest);
}

}  // namespace

MeshBuffer::MeshBuffer(const MeshData& mesh)
    : hasNormals_(!mesh.normals.empty()),
      hasTexCoords_(!mesh.texCoords.empty()),
      hasColors_(!mesh.colors.empty()) {
    glGenVertexArrays(1, &vertexArray_);
    glGenBuffers(kBuffers, buffers_);
    glBindVertexArray(vertexArray_);
    unit_ = drawingUnit(largestCoordinate(mesh.positions));
    if (unit_ == 1.0) {
        uploadAttribute(buffers_[0], 0, 3, mesh.positions);
    } else {
        std::vector<glm::vec3> positions;
        for (const glm::vec3& position : mesh.positions)
            positions.emplace_back(glm::dvec3(position) * (1.0 / unit_));
        uploadAttribute(buffers_[0], 0, 3, positions);
    }
    uploadAttribute(buffers_[1], 1, 3, mesh.normals);
    uploadAttribute(buffers_[2], 2, 2, mesh.texCoords);
    uploadAttribute(buffers_[3], 3, 3, mesh.colors);

    // Counting sort by slot.
    const std::vector<std::uint16_t>& slots = mesh.materialSlots;
    const std::size_t slotCount =
        slots.empty() ? 1 : static_cast<std::size_t>(*std::max_element(slots.begin(), slots.end())) + 1;
    std::vector<std::size_t> next(slotCount + 1, 0);
    if (slots.empty()) next[1] = mesh.triangles.size();
    for (const std::uint16_t slot : slots) ++next[slot + 1u];
    for (std::size_t slot = 0; slot < slotCount; ++slot) next[slot + 1] += next[slot];
    for (std::size_t slot = 0; slot < slotCount; ++slot)
        if (next[slot + 1] > next[slot])
            ranges_.push_back({static_cast<std::uint32_t>(slot),
                               static_cast<GLsizei>(3 * (next[slot + 1] - next[slot])), 3 * next[slot]});
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[4]);
    const auto bytes = static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(glm::uvec3));
    if (slots.empty()) {
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, bytes, mesh.triangles.data(), GL_STATIC_DRAW);
    } else {
        std::vector<glm::uvec3> sorted(mesh.triangles.size());
        for (std::size_t i = 0; i < slots.size(); ++i) sorted[next[slots[i]]++] = mesh.triangles[i];
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, bytes, sorted.data(), GL_STATIC_DRAW);
    }
    glBindVertexArray(0);
}

MeshBuffer::~MeshBuffer() {
    glDeleteVertexArrays(1, &vertexArray_);
    glDeleteBuffers(kBuffers, buffers_);
}

std::size_t MeshBuffer::draw(std::uint32_t slot) const {
    const Range* range = rangeOf(slot);
    if (range == nullptr) return 0;
    glBindVertexArray(vertexArray_);
    glDrawElements(GL_TRIANGLES, range->indexCount, GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(range->firstIndex * sizeof(GLuint)));
    return trianglesOf(slot);
}

std::size_t MeshBuffer::trianglesOf(std::uint32_t slot) const {
    const Range* range = rangeOf(slot);
    return range ? static_cast<std::size_t>(range->indexCount) / 3 : 0;
}

const MeshBuffer::Range* MeshBuffer::rangeOf(std::uint32_t slot) const {
    const auto found = std::find_if(ranges_.begin(), ranges_.end(),
                                    [slot](const Range& range) { return range.slot == slot; });
    return found != ranges_.end() ? &*found : nullptr;
}

MeshData unitSphereMesh() {
    constexpr std::uint32_t kRings = 32, kSectors = 64;
    MeshData mesh;
    for (std::uint32_t ring = 0; ring <= kRings; ++ring)
        for (std::uint32_t sector = 0; sector <= kSectors; ++sector) {
            const float theta = std::numbers::pi_v<float> * static_cast<float>(ring) / kRings;
            const float phi = 2.0f * std::numbers::pi_v<float> * static_cast<float>(sector) / kSectors;
            mesh.positions.push_back(
                {std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi)});
            // As shading::sphereTexCoords(); at a pole that of the middle of its triangle.
            const float middle = ring == 0 ? 0.5f : ring == kRings ? -0.5f : 0.0f;
            mesh.texCoords.push_back(
                {(static_cast<float>(sector) + middle) / kSectors, 1.0f - static_cast<float>(ring) / kRings});
        }
    mesh.normals = mesh.positions;
    for (std::uint32_t ring = 0; ring < kRings; ++ring)
        for (std::uint32_t sector = 0; sector < kSectors; ++sector) {
            const std::uint32_t a = ring * (kSectors + 1) + sector, b = a + kSectors + 1;
            mesh.triangles.push_back({a, b, b + 1});
            mesh.triangles.push_back({a, b + 1, a + 1});
        }
    return mesh;
}

}  // namespace rayscope::viewer
