#pragma once
#include <map>

#include "scene/mesh_files/gltf/accessor_reader.h"
#include "scene/mesh_files/gltf/scene_graph.h"
#include "scene/mesh_files/imported_mesh.h"

namespace rayscope::scene {

/// Collects the triangles of placed primitives in one mesh.
class GltfGeometry {
  public:
    /// The arguments must outlive the object. `placed`: all meshes that will be added; decides which vertex
    /// attributes the mesh has.
    GltfGeometry(const std::string& path, const GltfDocument& document, GltfAccessorReader& accessors,
                 const std::vector<GltfPlacement>& placed, Oddities& oddities);

    /// Adds a primitive; those without triangles are noted. Throws InputError if its accessors are invalid,
    /// or if the mesh exceeds the range of its indices.
    void add(const GltfPrimitive& primitive, const glm::dmat4& toScene);

    std::size_t triangles() const { return mesh_.triangles.size(); }
    /// The material of each slot; nothing: that of primitives without one.
    const std::vector<GltfIndex>& slots() const { return slots_; }
    /// To be called once, at the end.
    MeshData take();

  private:
    struct Vertices {
        std::vector<float> positions{}, normals{}, texCoords{}, colors{};
        std::size_t count = 0;
        std::uint32_t colorComponents = 3;
    };
    void checkRange(std::size_t count) const;
    bool isDrawn(const GltfPrimitive& primitive) const;
    GltfIndex attribute(const GltfPrimitive& primitive, const std::string& name) const;
    GltfIndex texCoordOf(const GltfPrimitive& primitive) const;
    Vertices readVertices(const GltfPrimitive& primitive);
    std::vector<float> readAttribute(GltfIndex accessor, std::uint32_t components, std::size_t count);
    std::vector<glm::uvec3> readTriangles(const GltfPrimitive& primitive, std::size_t vertices);
    void appendVertices(const GltfPrimitive& primitive, const Vertices& vertices, const glm::dmat4& toScene);
    void appendTexCoords(const GltfPrimitive& primitive, const std::vector<float>& texCoords,
                         std::size_t count);
    static void separateFaces(Vertices& vertices, std::vector<glm::uvec3>& triangles);
    void repairNormals(std::size_t firstVertex, std::size_t firstTriangle);
    void appendSlot(GltfIndex material, std::size_t count);

    const std::string& path_;
    const GltfDocument& document_;
    GltfAccessorReader& accessors_;
    Oddities& oddities_;
    bool hasNormals_ = false, hasTexCoords_ = false, hasColors_ = false;
    MeshData mesh_{};
    std::vector<GltfIndex> slots_{};
    std::map<std::int64_t, std::uint16_t> slotOf_{};
};

}  // namespace rayscope::scene
