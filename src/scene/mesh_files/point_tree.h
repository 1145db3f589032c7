#pragma once
#include <rayscope/vector.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rayscope::scene {

/// Bounding boxes over points of the plane in Morton order, to find those in a triangle.
class PointTree {
  public:
    /// `points` must outlive the tree; `indices` are the points in it.
    PointTree(const std::vector<glm::dvec2>& points, std::span<const std::uint32_t> indices);

    void remove(std::uint32_t index) { isIn_[index] = false; }

    /// Whether `predicate(index)` is true for a point of the tree in or near the triangle, which is
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
                if (isIn_[order_[i]] && predicate(order_[i])) return true;
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
    std::vector<bool> isIn_;
    std::vector<Box> boxes_;  ///< a complete binary tree: the children of node i are 2i and 2i + 1
    std::uint32_t firstLeaf_ = 1;
};

}  // namespace rayscope::scene
