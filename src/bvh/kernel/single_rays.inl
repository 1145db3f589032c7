// Queries of the wide tree ray by ray. Include after one of the lanes_*.inl.
#include "bvh/kernel/crossings.inl"

namespace rayscope::bvh::kernel {
namespace {

bool closestHit(const WideTreeView& tree, RayData ray, HitData& hit) {
    if (!isTraceable(ray)) return false;
    bool found;
    withPreparedRay(tree, ray, [&](const auto& lanes, QueryState& state) {
        FastShear shear{};
        traverseClosest(tree, tree.root, lanes, shear, state);
        found = state.best.primitive != kNoPrimitive;
        if (found) hit = state.best;
    });
    return found;
}

bool anyHit(const WideTreeView& tree, RayData ray) {
    if (!isTraceable(ray)) return false;
    bool found;
    withPreparedRay(tree, ray, [&](const auto& lanes, QueryState& state) {
        FastShear shear{};
        found = traverseAny(tree, tree.root, lanes, shear, state);
    });
    return found;
}

void closestHitsSequential(const WideTreeView& tree, const float* rays, HitData* hits, size_t count) {
    for (size_t i = 0; i < count; ++i) {
        hits[i] = {kInfinity, kNoPrimitive, 0.0f, 0.0f};
        closestHit(tree, rays + 8 * i, hits[i]);
    }
}

void anyHitsSequential(const WideTreeView& tree, const float* rays, uint8_t* occluded, size_t count) {
    for (size_t i = 0; i < count; ++i) occluded[i] = anyHit(tree, rays + 8 * i);
}

}  // namespace
}  // namespace rayscope::bvh::kernel
