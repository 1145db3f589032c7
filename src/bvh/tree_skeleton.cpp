#include "bvh/tree_skeleton.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "bvh/stop_check.h"

namespace rayscope {
namespace {

constexpr std::size_t kStopInterval = 65536;

BinaryNode makeNode(const Bounds4& box, std::size_t first, std::size_t count) {
    return {{box.lower[0], box.lower[1], box.lower[2]},
            static_cast<std::uint32_t>(first),
            {box.upper[0], box.upper[1], box.upper[2]},
            static_cast<std::uint32_t>(count)};
}

}  // namespace

TreeSkeleton::TreeSkeleton(std::size_t primitives, const BuildSettings& settings)
    : count_(primitives),
      settings_(settings),
      nodes_(std::make_unique_for_overwrite<BinaryNode[]>(2 * primitives)),
      primitives_(primitives) {}

std::pair<Subtree, Subtree> TreeSkeleton::split(const Subtree& tree, const Bounds4& box, std::size_t middle) {
    nodes_[tree.node] = makeNode(box, tree.below, 0);
    const std::size_t below = tree.below + 2;
    return {{tree.begin, middle, tree.below, below, tree.level + 1},
            {middle, tree.end, tree.below + 1, below + 2 * (middle - tree.begin) - 2, tree.level + 1}};
}

void TreeSkeleton::makeLeaf(const Subtree& tree, const Bounds4& box) {
    nodes_[tree.node] = makeNode(box, tree.begin, tree.size());
}

bool TreeSkeleton::mustBeHalved(const Subtree& tree) {
    return static_cast<int>(std::bit_width(tree.size())) >= kMaxTreeLevel - tree.level;
}

std::size_t TreeSkeleton::countNodes() const {
    std::vector<std::uint32_t> stack{0};
    std::size_t count = 0;
    while (!stack.empty()) {
        if (count++ % kStopInterval == 0) throwIfStopped(settings_.stop);
        const BinaryNode& node = nodes_[stack.back()];
        stack.pop_back();
        if (!node.isLeaf()) stack.insert(stack.end(), {node.first + 1, node.first});
    }
    return count;
}

BinaryTree TreeSkeleton::compact() {
    BinaryTree tree;
    if (count_ > 0) {
        tree.nodes.reserve(countNodes());
        tree.nodes.push_back(nodes_[0]);
    }
    struct Waiting {
        std::uint32_t node;
        int level;
    };
    std::vector<Waiting> stack;
    if (count_ > 0) stack.push_back({0, 0});
    while (!stack.empty()) {
        const auto [number, level] = stack.back();
        stack.pop_back();
        tree.levels = std::max(tree.levels, level + 1);
        BinaryNode& node = tree.nodes[number];
        if (node.isLeaf()) continue;
        const auto children = static_cast<std::uint32_t>(tree.nodes.size());
        if (children % kStopInterval == 1) throwIfStopped(settings_.stop);
        const std::uint32_t place = std::exchange(node.first, children);
        tree.nodes.push_back(nodes_[place]);
        tree.nodes.push_back(nodes_[place + 1]);
        stack.push_back({children + 1, level + 1});
        stack.push_back({children, level + 1});
    }
    tree.primitives = std::move(primitives_);
    nodes_.reset();
    return tree;
}

}  // namespace rayscope
