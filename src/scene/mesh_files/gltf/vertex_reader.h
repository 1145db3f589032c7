#pragma once
#include <span>
#include <vector>

#include "scene/mesh_files/gltf/accessor_reader.h"

namespace rayscope::scene {

/// Vertices of a primitive; optional attributes are empty if it has none.
struct GltfVertices {
    std::vector<float> positions{}, normals{};  ///< three per vertex
    std::vector<float> texCoords{};             ///< two per vertex, from the upper left corner
    std::vector<float> colors{};                ///< `colorComponents` per vertex
    std::size_t count = 0;
    std::uint32_t colorComponents = 3;
};

/// Element i of triples.
inline glm::dvec3 vectorAt(const std::vector<float>& values, std::size_t i) {
    return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}
/// Zero if the length is zero or not finite.
glm::dvec3 unitOrZero(const glm::dvec3& v);

bool mirrors(const glm::dmat3& map);
/// The map of normals that belongs to a map of points, up to a positive factor; exists for singular maps too.
glm::dmat3 normalMapOf(const glm::dmat3& map);

/// Reads the vertices of primitives.
class GltfVertexReader {
  public:
    /// The arguments must outlive the object.
    GltfVertexReader(const std::string& path, const GltfDocument& document, GltfAccessorReader& accessors,
                     Oddities& oddities)
        : path_(path), document_(document), accessors_(accessors), oddities_(oddities) {}

    /// The accessor of the texture coordinates that the material uses.
    GltfIndex texCoordsOf(const GltfPrimitive& primitive) const;

    /// The vertices of a primitive with positions, displaced by its morph targets. Attributes of another
    /// count are left out with a warning. Colours are read if `withColors`. Throws InputError if an accessor
    /// is invalid.
    GltfVertices read(const GltfPrimitive& primitive, std::span<const double> weights, bool withColors);

    /// Moves the vertices to the scene with the weighted mean of the matrices of their joints. False, with a
    /// warning, if the primitive has no joints and weights.
    bool applySkin(GltfVertices& vertices, const GltfPrimitive& primitive,
                   std::span<const glm::dmat4> joints);

  private:
    std::vector<float> readAttribute(GltfIndex accessor, std::uint32_t components, std::size_t count);
    void displace(std::vector<float>& values, const GltfAttributes& target, const std::string& semantic,
                  double weight);
    std::vector<glm::dmat4> skinMatrices(const GltfPrimitive& primitive, std::span<const glm::dmat4> joints,
                                         std::size_t count);

    const std::string& path_;
    const GltfDocument& document_;
    GltfAccessorReader& accessors_;
    Oddities& oddities_;
};

}  // namespace rayscope::scene
