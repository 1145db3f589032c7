#include "bvh/builders/build.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bvh/builders/builders.h"
#include "bvh/layout/primitive_refs.h"
#include "bvh/stop_check.h"

namespace rayscope::bvh {
namespace {

void checkRange(const char* name, int value, int lowest, int highest) {
    if (value < lowest || value > highest)
        throw std::invalid_argument(fmt::format("{} is {}; expected {} … {}", name, value, lowest, highest));
}

void checkSettings(const BuildSettings& settings) {
    checkRange("bins", settings.bins, 2, 4096);
    checkRange("maxLevel", settings.maxLevel, 0, kMaxTreeLevel);
    checkRange("leafSize", settings.leafSize, 1, std::numeric_limits<int>::max());
}

/// A power of two by which areas are scaled, so that they stay far from overflow and underflow.
float areaScale(const Bounds4& box) {
    const Float4 size = box.upper * broadcast(0.5f) - box.lower * broadcast(0.5f);
    const float longest = std::max({size[0], size[1], size[2], 0x1p-120f});
    return std::exp2(-static_cast<float>(std::ilogb(longest)) - 1.0f);
}

/// The number of triangles that are not split. In the wide layout so few triangles usually share one block
/// anyway. Unless the binary tree is kept, not splitting them saves a tenth of the build time, and rays test
/// 1 % more triangles.
std::size_t maxUnsplitTriangles(const AccelInput& input, const BuildSettings& settings) {
    const bool isKept = settings.keepBinaryTree || settings.layout == BvhLayout::Binary;
    return isKept || !input.spheres.empty() ? 1 : static_cast<std::size_t>(std::min(settings.leafSize, 4));
}

}  // namespace

RangeBounds boundsOf(std::span<const PrimitiveRef> refs, const std::stop_token& stop) {
    using Block = tbb::blocked_range<std::size_t>;
    const auto extend = [&](const Block& block, RangeBounds bounds) {
        throwIfStopped(stop);
        for (std::size_t i = block.begin(); i < block.end(); ++i) bounds.extend(refs[i]);
        return bounds;
    };
    const Block all(0, refs.size(), kTaskSize);
    if (!all.is_divisible()) return extend(all, {});
    return tbb::parallel_reduce(all, RangeBounds{}, extend, [](RangeBounds a, const RangeBounds& b) {
        a.box.extend(b.box);
        a.centroids.extend(b.centroids);
        return a;
    });
}

BinaryTree buildBinaryTree(const AccelInput& input, const BuildSettings& settings) {
    checkSettings(settings);
    PrimitiveRefs collected = collectPrimitiveRefs(input, settings.stop);
    const std::span<PrimitiveRef> refs = collected.refs;
    const bool reinserts = settings.builder == BvhBuilder::SahReinsertion;
    BuildSettings skeletonSettings = settings;
    if (reinserts) skeletonSettings.leafSize = 1;  // so that every primitive can be moved
    TreeSkeleton skeleton(refs.size(), skeletonSettings);
    float scale = 1.0f;
    if (!refs.empty()) {
        scale = areaScale(boundsOf(refs, settings.stop).box);
        switch (settings.builder) {
            case BvhBuilder::Median:
                buildMedian(skeleton, refs);
                break;
            case BvhBuilder::Sah:
                buildSweep(skeleton, refs, skeleton.whole(), scale);
                break;
            case BvhBuilder::SahBinned:
                buildBinned(skeleton, refs, scale, maxUnsplitTriangles(input, settings));
                break;
            case BvhBuilder::SahReinsertion:
                buildBinned(skeleton, refs, scale, 1);
                break;
        }
    }
    collected.refs = base::BigVector<PrimitiveRef>();
    BinaryTree tree = skeleton.compact();
    if (reinserts && !tree.nodes.empty()) tree = improveByReinsertion(tree, settings, scale);
    tree.droppedPrimitives = collected.dropped;
    return tree;
}

}  // namespace rayscope::bvh
