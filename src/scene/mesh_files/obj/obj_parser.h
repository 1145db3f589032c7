#pragma once
#include <rayscope/scene.h>

#include "scene/mesh_files/geometry/corner_table.h"
#include "scene/oddities.h"

namespace rayscope::scene {

/// The content of an OBJ file. All indices are valid.
struct ParsedObj {
    struct Polygon {
        std::uint32_t firstTriangle, corners;
        int line;
    };
    struct Named {
        std::string name;
        int line;  ///< of the first statement with this name; 0: none, as for faces before any usemtl
    };

    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> texCoords;
    std::vector<Rgb> colors;            ///< as written, per position; empty: none. NaN: not given
    std::vector<Corner> corners;        ///< distinct
    std::vector<glm::uvec3> triangles;  ///< indices into `corners`; polygons as fans
    std::vector<Polygon> polygons;      ///< those with more than three corners
    std::vector<std::uint16_t> slots;   ///< per triangle; empty if all have slot 0
    std::vector<Named> slotNames;       ///< materials by first use
    std::vector<Named> libraries;       ///< arguments of mtllib
};

/// Parses the text of readTextFile(). What is left out or odd is added to `oddities`. Throws InputError, with
/// line and column, at invalid numbers and positions that do not exist, and if there are no faces; and
/// Stopped.
ParsedObj parseObj(const std::string& path, std::string_view text, Oddities& oddities,
                   const LoadControl& control);

}  // namespace rayscope::scene
