#include "bvh/layout/statistics.h"

#include "bvh/bounds.h"

namespace rayscope::bvh {
namespace {

void count(std::vector<std::size_t>& histogram, std::size_t index) {
    if (histogram.size() <= index) histogram.resize(index + 1);
    ++histogram[index];
}

}  // namespace

double halfArea(const BinaryNode& node) {
    return halfAreaOf(glm::dvec3(node.upper) - glm::dvec3(node.lower));
}

TreeStatistics statisticsOf(const BinaryTree& tree) {
    TreeStatistics result;
    if (tree.nodes.empty()) return result;
    result.nodes = tree.nodes.size();
    result.primitives = tree.primitives.size();
    result.bytes = tree.nodes.size() * sizeof(BinaryNode) + tree.primitives.size() * sizeof(std::uint32_t);
    result.levels = tree.levels;
    const double rootArea = halfArea(tree.nodes[0]);
    struct StackEntry {
        std::uint32_t node;
        std::size_t level;
    };
    std::vector<StackEntry> stack{{0, 0}};
    while (!stack.empty()) {
        const auto [number, level] = stack.back();
        stack.pop_back();
        const BinaryNode& node = tree.nodes[number];
        const double area = rootArea > 0.0 ? halfArea(node) / rootArea : 1.0;
        if (node.isLeaf()) {
            result.sahCost += area * kIntersectionCost * node.count;
            ++result.leaves;
            count(result.leavesAtLevel, level);
            count(result.leavesOfSize, node.count);
        } else {
            result.sahCost += area * kTraversalCost;
            stack.push_back({node.first, level + 1});
            stack.push_back({node.first + 1, level + 1});
        }
    }
    return result;
}

}  // namespace rayscope::bvh
