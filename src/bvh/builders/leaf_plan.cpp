#include "bvh/builders/leaf_plan.h"

#include <algorithm>

#include "bvh/builders/builders.h"
#include "bvh/stop_check.h"

namespace rayscope::bvh {
LeafPlan::LeafPlan(const LinkedTree& tree, const BinaryTree& source, const BuildSettings& settings)
    : tree_(tree), source_(source), settings_(settings), plans_(tree.size()) {
    plan(tree.root());
}

const LeafPlan::Plan& LeafPlan::plan(std::uint32_t number) {
    if (number % kStopInterval == 0) throwIfStopped(settings_.stop);
    const LinkedTree::Node& node = tree_[number];
    const float area = node.box().halfArea(tree_.scale());
    Plan& result = plans_[number];
    if (node.isLeaf()) {
        const std::uint32_t count = source_.nodes[number].count;
        return result = {leafCost(area, count), count, 1};
    }
    const Plan &left = plan(node.left), &right = plan(node.right);
    const std::uint32_t count = left.primitives + right.primitives;
    const float asInner = splitCost(area, 0.0f) + left.cost + right.cost, asLeaf = leafCost(area, count);
    if (count <= static_cast<std::uint32_t>(settings_.leafSize) && asLeaf <= asInner)
        return result = {asLeaf, count, 1};
    return result = {asInner, count, left.nodes + right.nodes + 1};
}

BinaryTree LeafPlan::make() const {
    BinaryTree result;
    result.nodes.reserve(plans_[tree_.root()].nodes);
    result.primitives.reserve(source_.primitives.size());
    result.nodes.emplace_back();
    place(result, tree_.root(), 0, 0);
    return result;
}

void LeafPlan::place(BinaryTree& result, std::uint32_t number, std::size_t at, int level) const {
    if (number % kStopInterval == 0) throwIfStopped(settings_.stop);
    result.levels = std::max(result.levels, level + 1);
    const LinkedTree::Node& from = tree_[number];
    BinaryNode node{{from.lower[0], from.lower[1], from.lower[2]},
                    static_cast<std::uint32_t>(result.nodes.size()),
                    {from.upper[0], from.upper[1], from.upper[2]},
                    0};
    if (plans_[number].nodes > 1) {
        result.nodes[at] = node;
        result.nodes.resize(result.nodes.size() + 2);
        place(result, from.left, node.first, level + 1);
        place(result, from.right, node.first + 1, level + 1);
        return;
    }
    node.first = static_cast<std::uint32_t>(result.primitives.size());
    node.count = plans_[number].primitives;
    result.nodes[at] = node;
    placePrimitives(result, number);
}

void LeafPlan::placePrimitives(BinaryTree& result, std::uint32_t number) const {
    const LinkedTree::Node& node = tree_[number];
    if (!node.isLeaf()) {
        placePrimitives(result, node.left);
        placePrimitives(result, node.right);
        return;
    }
    const BinaryNode& leaf = source_.nodes[number];
    const auto first = source_.primitives.begin() + leaf.first;
    result.primitives.insert(result.primitives.end(), first, first + leaf.count);
}

}  // namespace rayscope::bvh
