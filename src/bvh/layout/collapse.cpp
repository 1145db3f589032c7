#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <stdexcept>

#include "bvh/layout/collapse_plan.h"
#include "bvh/layout/primitive_refs.h"
#include "bvh/layout/wide_tree.h"
#include "bvh/stop_check.h"

namespace rayscope::bvh {
namespace {

using kernel::ChildRef;
using kernel::kWidth;

/// The index of the first node, block and sphere of a subtree.
using Offsets = WideTreeSize;

constexpr std::uint32_t kMinParallelSubtree = 512;

void setBox(kernel::WideNode& node, int child, const float* lower, const float* upper) {
    for (int axis = 0; axis < 3; ++axis) {
        node.planes[2 * axis][child] = lower[axis];
        node.planes[2 * axis + 1][child] = upper[axis];
    }
}

void setEmpty(kernel::WideNode& node, int from) {
    const glm::vec3 highest(kernel::kInfinity), lowest(-kernel::kInfinity);
    for (int child = from; child < kWidth; ++child) {
        setBox(node, child, &highest.x, &lowest.x);
        node.child[child] = 0;
    }
}

class Collapser {
  public:
    Collapser(const BinaryTree& tree, const AccelInput& input, const std::stop_token& stop)
        : tree_(tree), input_(input), stop_(stop), plan_(tree, input, stop) {}

    WideTree run() {
        const WideTreeSize& count = plan_.countOf(0);
        if (count.blocks > kernel::kBlockIndexMask || count.spheres > kernel::kSphereIndexMask)
            throw std::length_error(
                fmt::format("{} triangle blocks and {} spheres exceed the limit of one BVH; split the scene",
                            count.blocks, count.spheres));
        wide_.nodes.resize(count.nodes);
        wide_.blocks.resize(count.blocks);
        wide_.spheres.resize(count.spheres);
        wide_.root = place(0, {});
        const glm::vec3 farthest = glm::max(glm::abs(tree_.nodes[0].lower), glm::abs(tree_.nodes[0].upper));
        wide_.maxCoordinate = glm::max(farthest.x, glm::max(farthest.y, farthest.z));
        return std::move(wide_);
    }

  private:
    /// Writes the subtree of a node from `at` on.
    ChildRef place(std::uint32_t number, Offsets at) {
        const BinaryNode& node = tree_.nodes[number];
        if (plan_.isLeaf(number))
            return node.isLeaf() ? placeLeaf(node, at) : placeBlock(slotsOf(number), at);
        const ChildRef ref = at.nodes++;
        const CollapsePlan::Children children = plan_.childrenOf(number);
        kernel::WideNode& wide = wide_.nodes[ref];
        std::array<Offsets, kWidth> offsets;
        for (int i = 0; i < children.count; ++i) {
            const auto index = static_cast<std::size_t>(i);
            const BinaryNode& child = tree_.nodes[children.node[index]];
            setBox(wide, i, &child.lower.x, &child.upper.x);
            offsets[index] = at;
            at = at + plan_.countOf(children.node[index]);
        }
        setEmpty(wide, children.count);
        const auto placeChild = [&](std::size_t i) { wide.child[i] = place(children.node[i], offsets[i]); };
        if (plan_.countOf(number).nodes > kMinParallelSubtree) {
            throwIfStopped(stop_);
            tbb::parallel_for(std::size_t{0}, static_cast<std::size_t>(children.count), placeChild);
        } else {
            for (std::size_t i = 0; i < static_cast<std::size_t>(children.count); ++i) placeChild(i);
        }
        return ref;
    }

    /// The primitives of a subtree are adjacent.
    std::span<const std::uint32_t> slotsOf(std::uint32_t number) const {
        const BinaryNode* first = &tree_.nodes[number];
        const BinaryNode* last = first;
        while (!first->isLeaf()) first = &tree_.nodes[first->first];
        while (!last->isLeaf()) last = &tree_.nodes[last->first + 1];
        return {tree_.primitives.data() + first->first, tree_.primitives.data() + last->first + last->count};
    }

    ChildRef placeBlock(std::span<const std::uint32_t> triangles, Offsets at) {
        kernel::TriangleBlock& block = wide_.blocks[at.blocks];
        for (std::size_t lane = 0; lane < kWidth; ++lane) {
            const std::uint32_t triangle = triangles[std::min(lane, triangles.size() - 1)];
            const glm::uvec3& index = input_.triangles[triangle];
            for (int corner = 0; corner < 3; ++corner)
                for (int axis = 0; axis < 3; ++axis)
                    block.corner[corner][axis][lane] = input_.vertices[index[corner]][axis];
            block.primitive[lane] = triangle;
        }
        return kernel::kBlockTag | static_cast<ChildRef>(triangles.size() - 1) << kernel::kBlockSizeShift |
               at.blocks;
    }

    ChildRef placeSphere(std::uint32_t primitive, Offsets at) {
        const Sphere& sphere = input_.spheres[primitive - input_.triangles.size()];
        wide_.spheres[at.spheres] = {{sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius},
                                     primitive};
        return kernel::kSphereTag | at.spheres;
    }

    /// A child for part of a binary leaf: a block of triangles or a sphere.
    struct Item {
        std::span<const std::uint32_t> primitives;
        glm::vec3 lower{kernel::kInfinity}, upper{-kernel::kInfinity};
    };

    ChildRef placeLeaf(const BinaryNode& leaf, Offsets at) {
        std::vector<std::uint32_t> order(tree_.primitives.begin() + leaf.first,
                                         tree_.primitives.begin() + leaf.first + leaf.count);
        const std::uint32_t triangles = trianglesIn(tree_, input_, leaf);
        if (triangles < leaf.count)
            std::stable_partition(order.begin(), order.end(),
                                  [&](std::uint32_t p) { return p < input_.triangles.size(); });
        std::vector<Item> items;
        const std::span<const std::uint32_t> all(order);
        for (std::size_t i = 0; i < triangles; i += kWidth)
            items.push_back(makeItem(all.subspan(i, std::min<std::size_t>(kWidth, triangles - i))));
        for (std::size_t i = triangles; i < leaf.count; ++i) items.push_back(makeItem(all.subspan(i, 1)));
        return placeItems(items, at);
    }

    Item makeItem(std::span<const std::uint32_t> primitives) const {
        Item item{primitives};
        for (const std::uint32_t primitive : primitives) {
            const PrimitiveBox box = boxOfPrimitive(input_, primitive);
            for (int axis = 0; axis < 3; ++axis) {
                item.lower[axis] = std::min(item.lower[axis], box.planes[axis]);
                item.upper[axis] = std::max(item.upper[axis], box.planes[axis + 4]);
            }
        }
        return item;
    }

    /// Writes several items and the nodes above them. Advances `at`.
    ChildRef placeItems(std::span<const Item> items, Offsets& at) {
        if (items.size() == 1) return placeItem(items[0], at);
        const ChildRef ref = at.nodes++;
        kernel::WideNode& node = wide_.nodes[ref];
        const std::size_t perChild = (items.size() + kWidth - 1) / kWidth;
        int child = 0;
        for (std::size_t i = 0; i < items.size(); i += perChild, ++child) {
            const auto part = items.subspan(i, std::min(perChild, items.size() - i));
            Item whole{{}};
            for (const Item& item : part) {
                whole.lower = glm::min(whole.lower, item.lower);
                whole.upper = glm::max(whole.upper, item.upper);
            }
            setBox(node, child, &whole.lower.x, &whole.upper.x);
            node.child[child] = placeItems(part, at);
        }
        setEmpty(node, child);
        return ref;
    }

    ChildRef placeItem(const Item& item, Offsets& at) {
        if (item.primitives[0] >= input_.triangles.size()) {
            const ChildRef ref = placeSphere(item.primitives[0], at);
            ++at.spheres;
            return ref;
        }
        const ChildRef ref = placeBlock(item.primitives, at);
        ++at.blocks;
        return ref;
    }

    const BinaryTree& tree_;
    const AccelInput& input_;
    const std::stop_token& stop_;
    CollapsePlan plan_;
    WideTree wide_;
};

}  // namespace

std::size_t WideTree::bytes() const {
    return nodes.capacity() * sizeof(kernel::WideNode) + blocks.capacity() * sizeof(kernel::TriangleBlock) +
           spheres.capacity() * sizeof(kernel::SphereRecord);
}

WideTree collapse(const BinaryTree& tree, const AccelInput& input, const std::stop_token& stop) {
    return Collapser(tree, input, stop).run();
}

}  // namespace rayscope::bvh
