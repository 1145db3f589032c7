#include "measure/bench/random_lines.h"

#include <cmath>
#include <random>

#include "bvh/intersect/intersect_box.h"
#include "bvh/layout/statistics.h"
#include "math/frame.h"

namespace rayscope::measure {
namespace {

/// Uniform random lines through a convex body intersect its surface at uniformly distributed points with
/// cosine-distributed angles (Santaló 1976, ch. 12).
class LinesThroughBox {
  public:
    LinesThroughBox(const glm::dvec3& lower, const glm::dvec3& upper) : lower_(lower), size_(upper - lower) {}

    Ray next() {
        const glm::dvec3 areas(size_.y * size_.z, size_.z * size_.x, size_.x * size_.y);
        const double chosen = real() * (areas.x + areas.y + areas.z);
        const int axis = chosen < areas.x ? 0 : chosen < areas.x + areas.y ? 1 : 2;
        const bool upper = real() < 0.5;
        glm::dvec3 point = lower_ + size_ * glm::dvec3(real(), real(), real());
        point[axis] = lower_[axis] + (upper ? size_[axis] : 0.0);
        glm::dvec3 inward(0.0);
        inward[axis] = upper ? -1.0 : 1.0;
        const math::Frame frame = math::frameAround(inward);
        const double sine = std::sqrt(real()), phi = 6.283185307179586 * real();
        const glm::dvec3 direction = std::sqrt(1.0 - sine * sine) * inward +
                                     sine * (std::cos(phi) * frame.u + std::sin(phi) * frame.v);
        return {glm::vec3(point - glm::length(size_) * direction), glm::vec3(direction)};
    }

  private:
    double real() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

    glm::dvec3 lower_, size_;
    std::mt19937_64 random_{1};
};

}  // namespace

double costOfRandomLines(const bvh::BinaryTree& tree, int lines) {
    if (tree.nodes.empty() || lines < 1) return 0.0;
    LinesThroughBox source(tree.nodes[0].lower, tree.nodes[0].upper);
    double cost = 0.0;
    std::vector<std::uint32_t> stack;
    for (int line = 0; line < lines; ++line) {
        const Ray ray = source.next();
        const bvh::BoxRay box(bvh::rayData(ray));
        stack.assign(1, 0);
        while (!stack.empty()) {
            const std::uint32_t number = stack.back();
            const bvh::BinaryNode& node = tree.nodes[number];
            stack.pop_back();
            float entry;
            // Lines intersect the root by construction, but rounding may miss it at its edges.
            if (number != 0 && !bvh::intersectBox(bvh::planes(node), box, box.tMax, entry)) continue;
            if (node.isLeaf()) {
                cost += bvh::kIntersectionCost * node.count;
            } else {
                cost += bvh::kTraversalCost;
                stack.insert(stack.end(), {node.first, node.first + 1});
            }
        }
    }
    return cost / lines;
}

}  // namespace rayscope::measure
