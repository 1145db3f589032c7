#pragma once
#include <rayscope/scene.h>

#include <array>
#include <span>

#include "scene/mesh_files/geometry/corner_table.h"
#include "scene/mesh_files/ply/ply_plan.h"

namespace rayscope::scene {

/// Rows of the element "vertex", a column per role; columns that the file does not have are undefined.
struct PlyVertices {
    static constexpr std::size_t kRows = 1024;
    std::size_t count = 0;
    std::array<std::array<float, kRows>, kPlyColumns> columns;
    std::array<int, kRows> lines;  ///< 0 in binary files
};

/// In place of an index that is not an integer.
constexpr std::int64_t kNoInteger = std::numeric_limits<std::int64_t>::min();

/// A face as it is stored.
struct PlyFace {
    std::vector<std::int64_t> corners;
    std::vector<float> texCoords;  ///< u and v per corner, if the plan has them
    std::int64_t textureNumber = 0;
    int line = 0;  ///< 0 in binary files
};

/// Makes a mesh of the rows of a PLY file.
class PlyMesh {
  public:
    PlyMesh(const PlyPlan& plan, Oddities& oddities, const LoadControl& control);

    /// Announces how many are expected.
    void reserve(std::uint64_t vertices, std::uint64_t triangles);

    void addVertices(const PlyVertices& rows);

    /// These return the first index that is not that of a vertex, or null.
    const std::int64_t* addFace(const PlyFace& face);
    const std::int64_t* addStripCorners(std::span<const std::int64_t> corners);
    void beginStrip() { stripLength_ = 0; }

    /// Throws InputError if there is no triangle.
    MeshData finish(const std::string& path);

  private:
    struct Polygon {
        std::size_t firstTriangle;
        std::uint32_t corners;
        int line;
    };

    bool isVertex(std::int64_t index) const { return static_cast<std::uint64_t>(index) < vertexCount_; }
    void addColors(const PlyVertices& rows, std::size_t first);
    void addSlots(std::int64_t number, std::size_t triangles, int line);
    std::uint32_t cornerOf(const PlyFace& face, std::size_t i);
    std::uint32_t cornerAt(std::int64_t vertex, const glm::vec2& uv);
    const glm::vec3& positionOf(std::uint32_t corner) const;
    void triangulateFan(const Polygon& polygon);
    void splitVertices();

    const PlyPlan& plan_;
    Oddities& oddities_;
    const LoadControl& control_;
    std::uint64_t vertexCount_;
    MeshData mesh_;
    CornerTable corners_;            ///< of position and the bits of u and v, with corner texture coordinates
    std::vector<Polygon> polygons_;  ///< fans that wait for positions
    std::vector<std::uint32_t> ring_;
    std::vector<glm::vec3> points_;
    std::vector<glm::uvec3> triangles_;
    std::array<std::uint32_t, 2> stripEnd_{};
    std::size_t stripLength_ = 0;
};

}  // namespace rayscope::scene
