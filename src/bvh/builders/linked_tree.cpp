#include "bvh/builders/linked_tree.h"

#include <algorithm>

#include "bvh/stop_check.h"

namespace rayscope::bvh {
namespace {

/// Gains below this fraction of the area saved by detaching are rounding errors.
constexpr double kMinRelativeGain = 1e-6;

bool isSame(const Bounds4& a, const Bounds4& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.lower[axis] != b.lower[axis] || a.upper[axis] != b.upper[axis]) return false;
    return true;
}

Bounds4 unionOf(Bounds4 a, const Bounds4& b) {
    a.extend(b);
    return a;
}

}  // namespace

Bounds4 LinkedTree::Node::box() const {
    // Node numbers as floats may be denormal, which makes arithmetic a hundred times slower.
    constexpr Int4 kAxes{-1, -1, -1, 0};
    Bounds4 box;
    std::memcpy(&box.lower, lower, sizeof box.lower);
    std::memcpy(&box.upper, upper, sizeof box.upper);
    box.lower = reinterpret_cast<Float4>(reinterpret_cast<Int4>(box.lower) & kAxes);
    box.upper = reinterpret_cast<Float4>(reinterpret_cast<Int4>(box.upper) & kAxes);
    return box;
}

void LinkedTree::Node::setBox(const Bounds4& box) {
    std::memcpy(lower, &box.lower, sizeof lower);
    std::memcpy(upper, &box.upper, sizeof upper);
}

LinkedTree::LinkedTree(const BinaryTree& source, float scale, const std::stop_token& stop)
    : nodes_(source.nodes.size()),
      parents_(source.nodes.size(), kNoNode),
      heights_(source.nodes.size()),
      mayMoveUp_(source.nodes.size()),
      scale_(scale) {
    // Children have larger numbers than their parents.
    for (std::size_t i = source.nodes.size(); i-- > 0;) {
        if (i % kStopInterval == 0) throwIfStopped(stop);
        copyNode(source, static_cast<std::uint32_t>(i));
    }
}

void LinkedTree::copyNode(const BinaryTree& source, std::uint32_t number) {
    const BinaryNode& from = source.nodes[number];
    Node& node = nodes_[number];
    std::memcpy(node.lower, &from.lower, sizeof node.lower);
    std::memcpy(node.upper, &from.upper, sizeof node.upper);
    node.left = node.right = kNoNode;
    mayMoveUp_[number] = from.count == 1;
    if (from.isLeaf()) return;
    node.left = from.first;
    node.right = from.first + 1;
    parents_[node.left] = parents_[node.right] = number;
    heights_[number] = static_cast<std::uint8_t>(1 + std::max(heights_[node.left], heights_[node.right]));
    mayMoveUp_[number] = mayMoveUp_[node.left] && mayMoveUp_[node.right];
}

void LinkedTree::replaceChild(std::uint32_t parent, std::uint32_t child, std::uint32_t by) {
    parents_[by] = parent;
    if (parent == kNoNode)
        root_ = by;
    else
        (nodes_[parent].left == child ? nodes_[parent].left : nodes_[parent].right) = by;
}

/// Updates boxes and heights from `node` up. Returns the reduction of the areas.
double LinkedTree::refitFrom(std::uint32_t number) {
    double saved = 0.0;
    for (; number != kNoNode; number = parents_[number]) {
        Node& node = nodes_[number];
        const Bounds4 before = node.box(), after = unionOf(nodes_[node.left].box(), nodes_[node.right].box());
        const auto height =
            static_cast<std::uint8_t>(1 + std::max(heights_[node.left], heights_[node.right]));
        if (height == heights_[number] && isSame(before, after)) break;
        saved += area(before) - area(after);
        node.setBox(after);
        heights_[number] = height;
    }
    return saved;
}

/// Removes a node and its parent; the sibling moves up.
double LinkedTree::detach(std::uint32_t node) {
    const std::uint32_t parent = parents_[node], other = sibling(node), above = parents_[parent];
    replaceChild(above, parent, other);
    return area(nodes_[parent].box()) + refitFrom(above);
}

/// Replaces `target` by `parent`, which is outside the tree, with the children `target` and `node`.
double LinkedTree::attach(std::uint32_t node, std::uint32_t parent, std::uint32_t target) {
    const std::uint32_t above = parents_[target];
    replaceChild(above, target, parent);
    nodes_[parent].left = target;
    nodes_[parent].right = node;
    parents_[target] = parents_[node] = parent;
    const Bounds4 box = unionOf(nodes_[target].box(), nodes_[node].box());
    nodes_[parent].setBox(box);
    heights_[parent] = static_cast<std::uint8_t>(1 + std::max(heights_[target], heights_[node]));
    return refitFrom(above) - area(box);
}

/// The level of a node, or −1 if it is in `subtree`.
int LinkedTree::levelOutside(std::uint32_t node, std::uint32_t subtree) const {
    int level = 0;
    for (; node != subtree && parents_[node] != kNoNode; node = parents_[node]) ++level;
    return node == subtree ? -1 : level;
}

double LinkedTree::moveIfBetter(std::uint32_t node, std::uint32_t target, int deepestLevel) {
    const std::uint32_t parent = parents_[node];
    if (parent == kNoNode) return 0.0;
    const std::uint32_t home = sibling(node);
    if (target == parent || target == home || !mayMoveUp_[node] || !mayMoveUp_[home]) return 0.0;
    const int level = levelOutside(target, node);
    if (level < 0 || level + 1 + std::max(heights_[node], heights_[target]) > deepestLevel) return 0.0;
    const double saved = detach(node);
    const double gain = saved + attach(node, parent, target);
    if (gain > kMinRelativeGain * saved) return gain;
    detach(node);
    attach(node, parent, home);
    return 0.0;
}

}  // namespace rayscope::bvh
