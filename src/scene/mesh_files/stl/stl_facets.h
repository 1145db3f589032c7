#pragma once
// Readers of the two kinds of STL files.
#include "base/block_reader.h"
#include "scene/load_step.h"
#include "scene/mesh_files/geometry/vertex_table.h"
#include "scene/oddities.h"

namespace rayscope::scene {

/// Bytes of a binary file: 80 of any content with the number of facets, and those of a facet.
inline constexpr std::size_t kStlHeaderSize = 84, kStlFacetSize = 50;

/// A facet as it is stored.
struct StlFacet {
    std::array<glm::vec3, 3> corners;
    glm::vec3 normal;
};

/// Collects facets; equal corners share a vertex.
class StlFacets {
  public:
    StlFacets(std::uint64_t expected, Oddities& oddities);

    /// `line`: 0 in binary files.
    void add(const StlFacet& facet, int line);
    /// Throws InputError if there is no facet.
    MeshData finish(const std::string& path);

  private:
    void flush();

    static constexpr std::size_t kMost = VertexTable::kMostAtOnce / 3;
    Oddities& oddities_;
    VertexTable vertices_;
    std::vector<glm::uvec3> triangles_;
    std::array<glm::vec3, 3 * kMost> corners_;  ///< of facets that are not in `triangles_` yet
    std::array<int, kMost> lines_;
    std::size_t waiting_ = 0;
};

/// What the readers share.
struct StlInput {
    const std::string& path;
    base::BlockReader& input;
    StlFacets& facets;
    Oddities& oddities;
    LoadStep& step;
};

/// Reads `count` facets behind the header of 84 bytes, or as many as there are. A wrong count, bytes behind
/// the last facet and attributes of facets are added to the oddities.
void readBinaryStl(const StlInput& stl, std::uint64_t count);

/// Throws InputError with line and column where the text is not "solid", facets, "endsolid", and so on.
void readAsciiStl(const StlInput& stl);

}  // namespace rayscope::scene
