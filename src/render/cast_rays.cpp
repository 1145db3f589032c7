#include "render/cast_rays.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <cassert>

namespace rayscope::render {

namespace {

/// Large enough that packets form and tasks cost nothing, small enough that threads end together.
constexpr std::size_t kGrain = 2048;

/// The hierarchy that answers for the whole world; null if there is none, or more than one.
const Accel* onlyAccel(const trace::World& world) {
    const bool one = world.settings.bvh && world.motionGroups.size() == 1 && !world.moves;
    return one ? world.motionGroups[0].accel.get() : nullptr;
}

template <class Answer>
void forBlocks(std::size_t count, Answer answer) {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, count, kGrain),
                              [&](const auto& range) { answer(range.begin(), range.size()); });
}

}  // namespace

void castClosest(const trace::World& world, std::span<const Ray> rays, std::span<Hit> hits) {
    assert(rays.size() == hits.size());
    const Accel* accel = onlyAccel(world);
    forBlocks(rays.size(), [&](std::size_t first, std::size_t count) {
        if (accel) return accel->closestHits(rays.subspan(first, count), hits.subspan(first, count));
        for (std::size_t i = first; i < first + count; ++i) {
            hits[i] = Hit{};
            world.closestHit(rays[i], 0.0f, hits[i]);
        }
    });
}

void castAny(const trace::World& world, std::span<const Ray> rays, std::span<std::uint8_t> occluded) {
    assert(rays.size() == occluded.size());
    const Accel* accel = onlyAccel(world);
    forBlocks(rays.size(), [&](std::size_t first, std::size_t count) {
        if (accel) return accel->anyHits(rays.subspan(first, count), occluded.subspan(first, count));
        for (std::size_t i = first; i < first + count; ++i) occluded[i] = world.anyHit(rays[i], 0.0f);
    });
}

}  // namespace rayscope::render
