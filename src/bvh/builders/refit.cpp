#include "bvh/builders/refit.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <functional>

#include "bvh/layout/primitive_refs.h"
#include "bvh/stop_check.h"

namespace rayscope::bvh {
namespace {

using kernel::ChildRef;
using kernel::kWidth;
using Block = tbb::blocked_range<std::size_t>;

constexpr std::size_t kPrimitivesPerTask = 2048;

/// Like Bounds4, but of equal coordinates (zeros with and without sign) keeps the earlier one.
struct Box {
    glm::vec3 lower{kernel::kInfinity}, upper{-kernel::kInfinity};

    void extend(const Box& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
    void extend(const PrimitiveBox& box) {
        extend(
            {{box.planes[0], box.planes[1], box.planes[2]}, {box.planes[4], box.planes[5], box.planes[6]}});
    }
    double halfArea() const { return halfAreaOf(glm::dvec3(upper) - glm::dvec3(lower)); }
};

Box boxOfChild(const kernel::WideNode& node, int child) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box.lower[axis] = node.planes[2 * axis][child];
        box.upper[axis] = node.planes[2 * axis + 1][child];
    }
    return box;
}

void setBoxOfChild(kernel::WideNode& node, int child, const Box& box) {
    for (int axis = 0; axis < 3; ++axis) {
        node.planes[2 * axis][child] = box.lower[axis];
        node.planes[2 * axis + 1][child] = box.upper[axis];
    }
}

bool isPresent(const kernel::WideNode& node, int child) {
    return node.planes[0][child] <= node.planes[1][child];
}

Box boxOfNode(const kernel::WideNode& node) {
    Box box;
    for (int child = 0; child < kWidth; ++child) box.extend(boxOfChild(node, child));
    return box;
}

/// Calls move(i) for all i < count, in parallel; whether all calls returned true.
template <class Move>
bool moveAll(std::size_t count, const std::stop_token& stop, const Move& move) {
    return tbb::parallel_reduce(
        Block(0, count, kPrimitivesPerTask), true,
        [&](const Block& block, bool isFinite) {
            throwIfStopped(stop);
            for (std::size_t i = block.begin(); i < block.end(); ++i) isFinite &= move(i);
            return isFinite;
        },
        std::logical_and<>{});
}

class WideRefitter {
  public:
    WideRefitter(const WideTree& tree, const AccelInput& input, const std::stop_token& stop)
        : from_(tree), input_(input), stop_(stop) {}

    std::optional<WideTree> run() {
        to_.nodes = from_.nodes;
        to_.blocks.resize(from_.blocks.size());
        to_.spheres = from_.spheres;
        to_.root = from_.root;
        boxOfBlock_.resize(from_.blocks.size());
        if (!moveAll(from_.blocks.size(), stop_, [this](std::size_t i) { return moveBlock(i); }) ||
            !moveAll(from_.spheres.size(), stop_, [this](std::size_t i) { return moveSphere(i); }))
            return std::nullopt;
        // Children have larger numbers than their parents.
        for (std::size_t i = to_.nodes.size(); i-- > 0;) {
            if (i % kStopInterval == 0) throwIfStopped(stop_);
            fit(to_.nodes[i]);
        }
        const Box whole = boxOf(to_.root);
        const glm::vec3 farthest = glm::max(glm::abs(whole.lower), glm::abs(whole.upper));
        to_.maxCoordinate = glm::max(farthest.x, glm::max(farthest.y, farthest.z));
        return std::move(to_);
    }

  private:
    bool moveBlock(std::size_t number) {
        kernel::TriangleBlock& block = to_.blocks[number];
        bool isFinite = true;
        for (int lane = 0; lane < kWidth; ++lane) {
            const std::uint32_t triangle = from_.blocks[number].primitive[lane];
            const glm::uvec3& index = input_.triangles[triangle];
            for (int corner = 0; corner < 3; ++corner)
                for (int axis = 0; axis < 3; ++axis)
                    block.corner[corner][axis][lane] = input_.vertices[index[corner]][axis];
            block.primitive[lane] = triangle;
            boxOfBlock_[number].extend(boxOfPrimitive(input_, triangle));
            isFinite &= hasFiniteCoordinates(input_, triangle);
        }
        return isFinite;
    }

    bool moveSphere(std::size_t number) {
        kernel::SphereRecord& record = to_.spheres[number];
        const Sphere& sphere = input_.spheres[record.primitive - input_.triangles.size()];
        record = {{sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius}, record.primitive};
        return hasFiniteCoordinates(input_, record.primitive);
    }

    Box boxOf(ChildRef child) const {
        if (!(child & kernel::kBlockTag)) return boxOfNode(to_.nodes[child]);
        if ((child & kernel::kTagMask) == kernel::kBlockTag)
            return boxOfBlock_[child & kernel::kBlockIndexMask];
        Box box;
        box.extend(boxOfPrimitive(input_, to_.spheres[child & kernel::kSphereIndexMask].primitive));
        return box;
    }

    void fit(kernel::WideNode& node) const {
        for (int child = 0; child < kWidth; ++child)
            if (isPresent(node, child)) setBoxOfChild(node, child, boxOf(node.child[child]));
    }

    const WideTree& from_;
    const AccelInput& input_;
    const std::stop_token& stop_;
    WideTree to_;
    std::vector<Box> boxOfBlock_;
};

}  // namespace

std::optional<WideTree> refitted(const WideTree& tree, const AccelInput& input, const std::stop_token& stop) {
    return WideRefitter(tree, input, stop).run();
}

std::optional<BinaryTree> refitted(const BinaryTree& tree, const AccelInput& input,
                                   const std::stop_token& stop) {
    BinaryTree result = tree;
    const auto fitLeaf = [&](std::size_t number) {
        BinaryNode& node = result.nodes[number];
        if (!node.isLeaf()) return true;
        Box box;
        bool isFinite = true;
        for (std::uint32_t slot = node.first; slot < node.first + node.count; ++slot) {
            box.extend(boxOfPrimitive(input, tree.primitives[slot]));
            isFinite &= hasFiniteCoordinates(input, tree.primitives[slot]);
        }
        node.lower = box.lower;
        node.upper = box.upper;
        return isFinite;
    };
    if (!moveAll(result.nodes.size(), stop, fitLeaf)) return std::nullopt;
    // Children have larger numbers than their parents.
    for (std::size_t i = result.nodes.size(); i-- > 0;) {
        if (i % kStopInterval == 0) throwIfStopped(stop);
        BinaryNode& node = result.nodes[i];
        if (node.isLeaf()) continue;
        const BinaryNode &left = result.nodes[node.first], &right = result.nodes[node.first + 1];
        node.lower = glm::min(left.lower, right.lower);
        node.upper = glm::max(left.upper, right.upper);
    }
    return result;
}

double sahCostOf(const WideTree& tree) {
    const bool isOneLeaf = (tree.root & kernel::kBlockTag) != 0;
    if (isOneLeaf) return 1.0;
    double sum = 0.0;
    std::size_t children = 0;
    for (const kernel::WideNode& node : tree.nodes)
        for (int child = 0; child < kWidth; ++child) {
            if (!isPresent(node, child)) continue;
            sum += boxOfChild(node, child).halfArea();
            ++children;
        }
    const double whole = boxOfNode(tree.nodes[tree.root]).halfArea();
    return 1.0 + (whole > 0.0 ? sum / whole : static_cast<double>(children));
}

}  // namespace rayscope::bvh
