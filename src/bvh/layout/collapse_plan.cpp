#include "bvh/layout/collapse_plan.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>

#include "bvh/bounds.h"
#include "bvh/kernel/ray_setup.h"
#include "bvh/kernel/wide_layout.h"
#include "bvh/stop_check.h"

namespace rayscope::bvh {
namespace {

/// Costs of a node and of a block of triangles, in units of a node.
constexpr float kNodeCost = 1.0f;
constexpr float kBlockCost = 1.0f;
constexpr int kParallelLevels = 7;
constexpr std::size_t kMinParallelTree = 4096;

float areaOf(const BinaryNode& node) { return halfAreaOf(node.upper - node.lower); }

std::uint32_t blocksFor(std::uint32_t triangles) { return (triangles + kernel::kWidth - 1) / kernel::kWidth; }

std::uint32_t nodesOver(std::uint32_t items) {
    if (items <= 1) return 0;
    if (items <= kernel::kWidth) return 1;
    const std::uint32_t perChild = (items + kernel::kWidth - 1) / kernel::kWidth;
    return 1 + items / perChild * nodesOver(perChild) + nodesOver(items % perChild);
}

}  // namespace

std::uint32_t trianglesIn(const BinaryTree& tree, const AccelInput& input, const BinaryNode& leaf) {
    if (input.spheres.empty()) return leaf.count;
    const auto first = tree.primitives.begin() + leaf.first;
    return static_cast<std::uint32_t>(std::count_if(
        first, first + leaf.count, [&](std::uint32_t p) { return p < input.triangles.size(); }));
}

WideTreeSize countOfLeaf(std::uint32_t triangles, std::uint32_t spheres) {
    const std::uint32_t blocks = blocksFor(triangles);
    return {nodesOver(blocks + spheres), blocks, spheres};
}

/// The cost of a subtree with up to i + 1 child slots.
struct CollapsePlan::Options {
    std::array<float, 8> cost;
    std::array<WideTreeSize, 8> count;
    std::uint32_t triangles;
    bool onlyTriangles;
};

CollapsePlan::CollapsePlan(const BinaryTree& tree, const AccelInput& input, const std::stop_token& stop)
    : tree_(tree),
      input_(input),
      stop_(stop),
      plans_(tree.nodes.size()),
      parallelLevels_(tree.nodes.size() > kMinParallelTree ? kParallelLevels : 0) {
    plan(0, 0);
}

CollapsePlan::Options CollapsePlan::planLeaf(std::uint32_t node) {
    const BinaryNode& leaf = tree_.nodes[node];
    Options options;
    options.triangles = trianglesIn(tree_, input_, leaf);
    options.onlyTriangles = options.triangles == leaf.count;
    plans_[node].leftSlots.fill(0);
    plans_[node].count = countOfLeaf(options.triangles, leaf.count - options.triangles);
    options.cost.fill(areaOf(leaf) * (kBlockCost + static_cast<float>(plans_[node].count.nodes) * kNodeCost));
    options.count.fill(plans_[node].count);
    return options;
}

CollapsePlan::Options CollapsePlan::plan(std::uint32_t number, int level) {
    const BinaryNode& node = tree_.nodes[number];
    if (node.isLeaf()) return planLeaf(number);
    Options left, right;
    if (level < parallelLevels_) {
        throwIfStopped(stop_);
        tbb::parallel_invoke([&] { left = plan(node.first, level + 1); },
                             [&] { right = plan(node.first + 1, level + 1); });
    } else {
        left = plan(node.first, level + 1);
        right = plan(node.first + 1, level + 1);
    }
    Plan& plan = plans_[number];
    Options options;
    options.triangles = left.triangles + right.triangles;
    options.onlyTriangles = left.onlyTriangles && right.onlyTriangles;

    const auto distribute = [&](int slots, std::uint8_t& leftSlots, WideTreeSize& count) {
        float cheapest = kernel::kInfinity;
        leftSlots = 1;
        for (int k = 1; k < slots; ++k) {
            const float cost = left.cost[static_cast<std::size_t>(k - 1)] +
                               right.cost[static_cast<std::size_t>(slots - k - 1)];
            if (cost >= cheapest) continue;
            cheapest = cost;
            leftSlots = static_cast<std::uint8_t>(k);
        }
        count = left.count[leftSlots - 1u] + right.count[static_cast<std::size_t>(slots - leftSlots - 1)];
        return cheapest;
    };
    const float area = areaOf(node);
    options.cost[0] = area * kNodeCost + distribute(kernel::kWidth, plan.leftSlots[0], options.count[0]);
    ++options.count[0].nodes;
    if (options.onlyTriangles && options.triangles <= kernel::kWidth &&
        area * kBlockCost <= options.cost[0]) {
        options.cost[0] = area * kBlockCost;
        options.count[0] = {0, 1, 0};
        plan.leftSlots[0] = 0;
    }
    for (std::size_t i = 1; i < 8; ++i) {
        options.cost[i] = distribute(static_cast<int>(i) + 1, plan.leftSlots[i], options.count[i]);
        if (options.cost[i] < options.cost[i - 1]) continue;
        options.cost[i] = options.cost[i - 1];
        options.count[i] = options.count[i - 1];
        plan.leftSlots[i] = 0;
    }
    plan.count = options.count[0];
    return options;
}

void CollapsePlan::take(std::uint32_t node, std::uint8_t slots, Children& children) const {
    const Plan& plan = plans_[node];
    while (slots > 1 && (tree_.nodes[node].isLeaf() || plan.leftSlots[slots - 1u] == 0)) --slots;
    if (slots == 1) {
        children.node[static_cast<std::size_t>(children.count++)] = node;
        return;
    }
    const std::uint8_t left = plan.leftSlots[slots - 1u];
    take(tree_.nodes[node].first, left, children);
    take(tree_.nodes[node].first + 1, static_cast<std::uint8_t>(slots - left), children);
}

CollapsePlan::Children CollapsePlan::childrenOf(std::uint32_t node) const {
    Children children;
    const std::uint8_t left = plans_[node].leftSlots[0];
    take(tree_.nodes[node].first, left, children);
    take(tree_.nodes[node].first + 1, static_cast<std::uint8_t>(kernel::kWidth - left), children);
    return children;
}

}  // namespace rayscope::bvh
