#pragma once
#include <rayscope/scene.h>

#include <set>

#include "scene/mesh_files/corner_table.h"

namespace rayscope::scene {

/// The content of an OBJ file. Indices are zero-based, but not yet checked against the number of elements.
struct ParsedObj {
    struct Polygon {
        std::uint32_t firstTriangle, corners;
    };
    struct Named {
        std::string name;
        int line;
    };

    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> texCoords;
    CornerTable corners;
    std::vector<int> firstLines;        ///< per distinct corner: line of its first use
    std::vector<glm::uvec3> triangles;  ///< indices of distinct corners; polygons as fans
    std::vector<Polygon> polygons;      ///< those with more than three corners
    std::vector<std::uint16_t> slots;   ///< per triangle; empty if all have slot 0
    std::vector<Named> slotNames;       ///< materials by first use; "": before any usemtl
    std::vector<Named> libraries;       ///< arguments of mtllib
    std::set<std::string> ignored;      ///< keywords of unknown statements
    std::size_t degenerateFaces = 0;    ///< faces with fewer than three vertices, ignored
    int firstDegenerateFace = 0;        ///< line of the first of them
    std::size_t nonFiniteVertices = 0;  ///< positions with a NaN or an infinity
    int firstNonFiniteVertex = 0;
};

/// Throws InputError, with the line, at invalid numbers and at negative indices before the first element.
ParsedObj parseObj(const std::string& path);

/// Throws the InputError about an index of `what`, e.g. "vertex", with the valid range for `count` elements.
[[noreturn]] void failObjIndex(const std::string& path, int line, std::string_view what, std::int64_t index,
                               std::size_t count);

}  // namespace rayscope::scene
