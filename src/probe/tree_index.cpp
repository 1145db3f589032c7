#include "probe/tree_index.h"

#include <algorithm>

#include "bvh/layout/statistics.h"

namespace rayscope::probe {

namespace {

/// All nodes, parents before children and left before right.
std::vector<std::uint32_t> preorder(const bvh::BinaryTree& tree) {
    std::vector<std::uint32_t> order, stack;
    if (!tree.nodes.empty()) stack.push_back(0);
    order.reserve(tree.nodes.size());
    while (!stack.empty()) {
        const std::uint32_t number = stack.back();
        stack.pop_back();
        order.push_back(number);
        const bvh::BinaryNode& node = tree.nodes[number];
        if (!node.isLeaf()) stack.insert(stack.end(), {node.first + 1, node.first});
    }
    return order;
}

}  // namespace

std::size_t TreeIndex::leafNumber(std::uint32_t node) const {
    return static_cast<std::size_t>(std::find(leaves.begin(), leaves.end(), node) - leaves.begin());
}

TreeIndex indexTree(const bvh::BinaryTree& tree) {
    TreeIndex index;
    const std::size_t count = tree.nodes.size();
    index.parent.assign(count, bvh::kNoNode);
    index.level.assign(count, 0);
    index.primitives.assign(count, 0);
    index.cost.assign(count, 0.0);
    const std::vector<std::uint32_t> order = preorder(tree);
    for (const std::uint32_t number : order) {
        const bvh::BinaryNode& node = tree.nodes[number];
        if (node.isLeaf()) {
            index.leaves.push_back(number);
            continue;
        }
        for (const std::uint32_t child : {node.first, node.first + 1}) {
            index.parent[child] = number;
            index.level[child] = static_cast<std::uint8_t>(index.level[number] + 1);
        }
    }
    // From the leaves up. If the root has no area, every relative area counts as 1.
    const bool hasArea = count > 0 && bvh::halfArea(tree.nodes[0]) > 0.0;
    for (auto it = order.rbegin(); it != order.rend(); ++it) {
        const bvh::BinaryNode& node = tree.nodes[*it];
        if (node.isLeaf()) {
            index.primitives[*it] = node.count;
            index.cost[*it] = bvh::kIntersectionCost * node.count;
            continue;
        }
        const double area = bvh::halfArea(node);
        double cost = bvh::kTraversalCost;
        for (const std::uint32_t child : {node.first, node.first + 1}) {
            index.primitives[*it] += index.primitives[child];
            const double probability = hasArea && area > 0.0 ? bvh::halfArea(tree.nodes[child]) / area : 1.0;
            cost += probability * index.cost[child];
        }
        index.cost[*it] = cost;
    }
    return index;
}

std::vector<std::uint32_t> nodesAtLevel(const bvh::BinaryTree& tree, const TreeIndex& index, int level,
                                        bool leavesAbove) {
    std::vector<std::uint32_t> nodes, stack;
    if (!tree.nodes.empty()) stack.push_back(0);
    while (!stack.empty()) {
        const std::uint32_t number = stack.back();
        stack.pop_back();
        const bvh::BinaryNode& node = tree.nodes[number];
        if (index.level[number] == level || (leavesAbove && node.isLeaf()))
            nodes.push_back(number);
        else if (!node.isLeaf())
            stack.insert(stack.end(), {node.first + 1, node.first});
    }
    return nodes;
}

std::span<const std::uint32_t> primitivesOfLeaf(const bvh::BinaryTree& tree, std::uint32_t number) {
    const bvh::BinaryNode& node = tree.nodes[number];
    if (!node.isLeaf()) return {};
    return std::span(tree.primitives).subspan(node.first, node.count);
}

double childOverlap(const bvh::BinaryTree& tree, std::uint32_t number) {
    const bvh::BinaryNode& node = tree.nodes[number];
    if (node.isLeaf()) return 0.0;
    const bvh::BinaryNode &left = tree.nodes[node.first], &right = tree.nodes[node.first + 1];
    bvh::BinaryNode overlap{};
    overlap.lower = glm::max(left.lower, right.lower);
    overlap.upper = glm::min(left.upper, right.upper);
    const bool isEmpty = !glm::all(glm::lessThanEqual(overlap.lower, overlap.upper));
    const double area = bvh::halfArea(node);
    return !isEmpty && area > 0.0 ? bvh::halfArea(overlap) / area : 0.0;
}

LevelComparison compareAtLevel(const bvh::BinaryTree& a, const TreeIndex& indexA, const bvh::BinaryTree& b,
                               const TreeIndex& indexB, int level) {
    LevelComparison result;
    const bvh::BinaryTree* trees[] = {&a, &b};
    const TreeIndex* indices[] = {&indexA, &indexB};
    for (int side = 0; side < 2; ++side) {
        const bvh::BinaryTree& tree = *trees[side];
        if (tree.nodes.empty()) continue;
        result.sahCost[side] = indices[side]->cost[0];
        const double rootArea = bvh::halfArea(tree.nodes[0]);
        for (const std::uint32_t node : nodesAtLevel(tree, *indices[side], level, false)) {
            ++result.boxes[side];
            result.expectedHits[side] += rootArea > 0.0 ? bvh::halfArea(tree.nodes[node]) / rootArea : 1.0;
        }
    }
    return result;
}

}  // namespace rayscope::probe
