#pragma once
#include <rayscope/vector.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rayscope::scene {

/// Numbers distinct points, compared bit by bit, in the order of their first occurrence. Open addressing: 8
/// to 16 bytes per point beside the point itself.
class VertexTable {
  public:
    /// Room for about `expected` distinct points.
    explicit VertexTable(std::size_t expected);

    static constexpr std::size_t kMostAtOnce = 384;
    /// The numbers of at most kMostAtOnce points. Throws std::length_error from 2^32 − 1 distinct points on.
    void indicesOf(std::span<const glm::vec3> points, std::uint32_t* indices);

    const std::vector<glm::vec3>& points() const { return points_; }
    std::vector<glm::vec3> takePoints() { return std::move(points_); }

  private:
    void grow();
    std::uint32_t indexOf(const glm::vec3& point, std::size_t slot);

    std::vector<glm::vec3> points_;
    std::vector<std::uint32_t> slots_;
};

}  // namespace rayscope::scene
