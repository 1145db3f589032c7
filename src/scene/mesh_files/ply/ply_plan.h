#pragma once
#include <array>
#include <limits>

#include "scene/mesh_files/ply/ply_header.h"

namespace rayscope::scene {

/// What a property of a PLY file is read as. The roles up to B are columns of PlyVertices.
enum class PlyRole : std::uint8_t {
    X,
    Y,
    Z,
    Nx,
    Ny,
    Nz,
    U,
    V,
    R,
    G,
    B,
    Ignored,
    Indices,
    TexCoords,
    TexNumber
};
constexpr std::size_t kPlyColumns = static_cast<std::size_t>(PlyRole::Ignored);

/// What is read of a PLY file.
struct PlyPlan {
    PlyHeader header;
    std::vector<std::vector<PlyRole>> roles;  ///< [element][property]
    std::size_t vertices, faces, strips;      ///< indices of elements; the number of elements: there is none
    bool hasNormals = false, hasTexCoords = false, hasColors = false;
    bool hasCornerTexCoords = false;  ///< faces list texture coordinates of their corners
    bool hasTextureNumbers = false;   ///< faces have the number of a texture file
    /// The largest value of the type of the columns R, G and B; 1 for floating-point types.
    std::array<float, 3> largestColor{1.0f, 1.0f, 1.0f};

    std::uint64_t countOf(std::size_t element) const {
        return element < header.elements.size() ? header.elements[element].count : 0;
    }
    std::uint64_t vertexCount() const { return countOf(vertices); }
};

/// Decides by the names of elements and properties what is read; what is not is added to `oddities`. Colours
/// are read if `withColors`. Throws InputError, with the line, if there are no points or no faces.
PlyPlan planPly(const std::string& path, PlyHeader header, bool withColors, Oddities& oddities);

}  // namespace rayscope::scene
