#pragma once
#include <map>
#include <span>
#include <vector>

#include "scene/imported_mesh.h"
#include "scene/mesh_files/gltf/scene_graph.h"
#include "scene/mesh_files/gltf/vertex_reader.h"

namespace rayscope::scene {

/// Collects the triangles of placed primitives in one mesh.
class GltfGeometry {
  public:
    /// The arguments must outlive the object. `placed`: all meshes that will be added; decides which vertex
    /// attributes the mesh has; colours only if `withColors`.
    GltfGeometry(const std::string& path, const GltfDocument& document, GltfAccessorReader& accessors,
                 const std::vector<GltfPlacement>& placed, bool withColors, Oddities& oddities);

    /// Adds a primitive once per matrix; those without triangles are noted. `weights` are those of its morph
    /// targets. `joints`: matrices of the joints of its skin, empty if it has none. Throws InputError if its
    /// accessors are invalid, or if the mesh exceeds the range of its indices.
    void add(const GltfPrimitive& primitive, const std::vector<double>& weights,
             const std::vector<glm::dmat4>& joints, const std::vector<glm::dmat4>& toScene);

    bool isEmpty() const { return mesh_.triangles.empty(); }
    /// The material of each slot; nothing: that of primitives without one.
    const std::vector<GltfIndex>& slots() const { return slots_; }
    /// Multiplies the vertex colours by the colours of the materials of the slots: the format multiplies
    /// them, a mesh that shows vertex colours replaces kd by them. Textures already have that factor.
    void multiplyColors(const std::vector<Material>& materials);
    /// To be called once, at the end.
    MeshData take();

  private:
    void checkRange(std::size_t count) const;
    std::vector<glm::uvec3> readTriangles(const GltfPrimitive& primitive, std::size_t vertices);
    void append(const GltfPrimitive& primitive, const GltfVertices& vertices,
                std::span<const glm::uvec3> triangles, const glm::dmat4& toScene, bool isFlat);
    void appendVertices(const GltfPrimitive& primitive, const GltfVertices& vertices,
                        const glm::dmat4& toScene);
    void appendTexCoords(const GltfPrimitive& primitive, const std::vector<float>& texCoords,
                         std::size_t count);
    static void separateFaces(GltfVertices& vertices, std::vector<glm::uvec3>& triangles);
    void repairNormals(std::size_t firstVertex, std::size_t firstTriangle);
    void appendSlot(GltfIndex material, std::size_t count);

    const std::string& path_;
    const GltfDocument& document_;
    GltfAccessorReader& accessors_;
    GltfVertexReader reader_;
    Oddities& oddities_;
    bool hasNormals_ = false, hasTexCoords_ = false, hasColors_ = false;
    MeshData mesh_{};
    std::vector<GltfIndex> slots_{};
    std::map<std::int64_t, std::uint16_t> slotOf_{};
};

}  // namespace rayscope::scene
