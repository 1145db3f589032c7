#include "scene/mesh_files/geometry/point_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace rayscope::scene {

namespace {

/// The bits of a 32-bit number at the even positions.
std::uint64_t spread(std::uint64_t x) {
    x = (x | x << 16) & 0x0000ffff0000ffffu;
    x = (x | x << 8) & 0x00ff00ff00ff00ffu;
    x = (x | x << 4) & 0x0f0f0f0f0f0f0f0fu;
    x = (x | x << 2) & 0x3333333333333333u;
    return (x | x << 1) & 0x5555555555555555u;
}

}  // namespace

PointTree::PointTree(const std::vector<glm::dvec2>& points, std::span<const std::uint32_t> indices)
    : positions_(points.size()) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Box all{glm::dvec2(kInfinity), glm::dvec2(-kInfinity)};
    for (const std::uint32_t i : indices) {
        all = {glm::min(all.lower, points[i]), glm::max(all.upper, points[i])};
    }
    const glm::dvec2 size = glm::max(all.upper - all.lower, glm::dvec2(std::numeric_limits<double>::min()));
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    keys.reserve(indices.size());
    for (const std::uint32_t i : indices) {
        const glm::dvec2 cell = (points[i] - all.lower) / size * 4294967295.0;
        keys.emplace_back(
            spread(static_cast<std::uint64_t>(cell.x)) | spread(static_cast<std::uint64_t>(cell.y)) << 1, i);
    }
    std::sort(keys.begin(), keys.end());
    order_.reserve(keys.size());
    sorted_.reserve(keys.size());
    for (const auto& [key, index] : keys) {
        positions_[index] = static_cast<std::uint32_t>(order_.size());
        order_.push_back(index);
        sorted_.push_back(points[index]);
    }

    const std::size_t leaves =
        std::bit_ceil(std::max<std::size_t>((order_.size() + kLeafSize - 1) / kLeafSize, 1));
    firstLeaf_ = static_cast<std::uint32_t>(leaves);
    boxes_.assign(2 * leaves, {glm::dvec2(kInfinity), glm::dvec2(-kInfinity)});
    for (std::size_t i = 0; i < order_.size(); ++i) {
        Box& box = boxes_[leaves + i / kLeafSize];
        const glm::dvec2& p = sorted_[i];
        box = {glm::min(box.lower, p), glm::max(box.upper, p)};
    }
    for (std::size_t node = leaves - 1; node > 0; --node)
        boxes_[node] = {glm::min(boxes_[2 * node].lower, boxes_[2 * node + 1].lower),
                        glm::max(boxes_[2 * node].upper, boxes_[2 * node + 1].upper)};
}

PointTree::Query::Query(const std::array<glm::dvec2, 3>& triangle) : from(triangle) {
    for (std::size_t i = 0; i < 3; ++i) edge[i] = triangle[(i + 1) % 3] - triangle[i];
    bounds = {glm::min(glm::min(from[0], from[1]), from[2]), glm::max(glm::max(from[0], from[1]), from[2])};
}

bool PointTree::Query::overlaps(const Box& box) const {
    if (bounds.upper.x < box.lower.x || bounds.lower.x > box.upper.x || bounds.upper.y < box.lower.y ||
        bounds.lower.y > box.upper.y)
        return false;
    for (std::size_t i = 0; i < 3; ++i) {
        // The corner of the box that is farthest on the inner side of the edge.
        const double up = edge[i].x * ((edge[i].x >= 0.0 ? box.upper.y : box.lower.y) - from[i].y);
        const double right = edge[i].y * ((edge[i].y >= 0.0 ? box.lower.x : box.upper.x) - from[i].x);
        constexpr double kBound = 4.0 * std::numeric_limits<double>::epsilon();
        if (up - right < -kBound * (std::abs(up) + std::abs(right))) return false;
    }
    return true;
}

}  // namespace rayscope::scene
