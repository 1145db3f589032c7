#pragma once
#include <rayscope/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace rayscope::scene {

/// Bounding boxes over points of the plane in Morton order, to find those in a triangle.
class PointTree {
  public:
    /// `indices` are the points in the tree.
    PointTree(const std::vector<glm::dvec2>& points, std::span<const std::uint32_t> indices);

    /// `index` must be in the tree.
    void remove(std::uint32_t index) {
        sorted_[positions_[index]] = glm::dvec2(std::numeric_limits<double>::quiet_NaN());
    }

    /// Whether `predicate(index, point)` is true for a point of the tree in or near the triangle, which is
    /// counter-clockwise or has no area. It is called for all points in the triangle and on its outline until
    /// it returns true.
    template <class Predicate>
    bool anyInTriangle(const std::array<glm::dvec2, 3>& triangle, Predicate predicate) const {
        const Query query(triangle);
        std::array<std::uint32_t, 64> stack;
        std::size_t size = 0;
        stack[size++] = 1;
        while (size > 0) {
            const std::uint32_t node = stack[--size];
            if (!query.overlaps(boxes_[node])) continue;
            if (node < firstLeaf_) {
                stack[size++] = 2 * node + 1;
                stack[size++] = 2 * node;
                continue;
            }
            const std::size_t begin = (node - firstLeaf_) * kLeafSize;
            const std::size_t end = std::min(begin + kLeafSize, order_.size());
            for (std::size_t i = begin; i < end; ++i)
                if (!std::isnan(sorted_[i].x) && predicate(order_[i], sorted_[i])) return true;
        }
        return false;
    }

  private:
    struct Box {
        glm::dvec2 lower, upper;  ///< an empty box has its lower above its upper corner
    };
    static constexpr std::size_t kLeafSize = 8;
    struct Query {
        explicit Query(const std::array<glm::dvec2, 3>& triangle);
        bool overlaps(const Box& box) const;
        std::array<glm::dvec2, 3> from, edge;  ///< the edges of the triangle
        Box bounds;
    };

    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> positions_;  ///< per index: where it is in order_
    std::vector<glm::dvec2> sorted_;        ///< the points of order_; NaN: removed
    std::vector<Box> boxes_;  ///< a complete binary tree: the children of node i are 2i and 2i + 1
    std::uint32_t firstLeaf_ = 1;
};

}  // namespace rayscope::scene
