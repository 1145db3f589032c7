#pragma once
#include <rayscope/vector.h>
#include <cstdint>

#include "base/big_vector.h"

namespace rayscope::bvh {

/// The deepest level of any tree (the root is level 0); the size of traversal stacks.
inline constexpr int kMaxTreeLevel = 64;

/// The children of an inner node are `first` and `first + 1`; a leaf has primitives[first … first + count).
struct BinaryNode {
    glm::vec3 lower;
    std::uint32_t first;
    glm::vec3 upper;
    std::uint32_t count;  ///< 0: inner node
    bool isLeaf() const { return count > 0; }
};
static_assert(sizeof(BinaryNode) == 32);

/// Marks the absence of a node.
inline constexpr std::uint32_t kNoNode = 0xffffffffu;

/// A binary bounding volume hierarchy; node 0 is the root. Empty without primitives.
struct BinaryTree {
    base::BigVector<BinaryNode> nodes;
    base::BigVector<std::uint32_t> primitives;  ///< triangles first, then spheres, as in Hit::primitive
    int levels = 0;                             ///< including the root
    std::uint32_t droppedPrimitives = 0;        ///< left out because of NaN or infinite coordinates
};

}  // namespace rayscope::bvh
