#pragma once
// The wide tree: eight children per node and up to eight triangles per leaf, both as structures of arrays.
#include <stddef.h>
#include <stdint.h>

namespace rayscope::bvh::kernel {

constexpr int kWidth = 8;

/// What a child is: an inner node, a block of up to eight triangles, or a sphere. The two highest bits say
/// which; blocks have the number of their triangles minus one in the next three.
using ChildRef = uint32_t;
constexpr ChildRef kBlockTag = 0x80000000u;
constexpr ChildRef kSphereTag = 0xc0000000u;
constexpr ChildRef kTagMask = 0xc0000000u;
constexpr ChildRef kBlockIndexMask = 0x07ffffffu;
constexpr ChildRef kSphereIndexMask = 0x3fffffffu;
constexpr int kBlockSizeShift = 27;
[[gnu::always_inline]] constexpr uint32_t trianglesIn(ChildRef block) {
    return (block >> kBlockSizeShift & 7u) + 1u;
}

/// The boxes of up to eight children; the box of a missing child is inverted, and never hit.
struct alignas(64) WideNode {
    float planes[6][kWidth];  ///< lower and upper x, lower and upper y, lower and upper z
    ChildRef child[kWidth];
};
static_assert(sizeof(WideNode) == 256);

/// The corners and numbers of up to eight triangles.
struct alignas(64) TriangleBlock {
    float corner[3][3][kWidth];  ///< corner, axis, triangle
    uint32_t primitive[kWidth];
};
static_assert(sizeof(TriangleBlock) == 320);

/// A sphere and its primitive number.
struct SphereRecord {
    float sphere[4];  ///< center, radius
    uint32_t primitive;
};

/// Inner nodes and leaves. The longest path has at most kMaxWideLevels inner nodes.
struct WideTreeView {
    const WideNode* nodes;
    const TriangleBlock* blocks;
    const SphereRecord* spheres;
    ChildRef root;
    float maxCoordinate;  ///< absolute coordinate of any box
};
constexpr int kMaxWideLevels = 76;

}  // namespace rayscope::bvh::kernel
