#include "render/cast_rays.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include "base/check_argument.h"

namespace rayscope::render {

namespace {

/// Large enough for packets and for a small overhead per task, small enough for an even load.
constexpr std::size_t kGrain = 2048;

template <class Query>
void forBlocks(std::size_t count, Query query, std::size_t grain = kGrain) {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, count, grain),
                              [&](const auto& range) { query(range.begin(), range.size()); });
}

}  // namespace

void castClosest(const trace::World& world, std::span<const Ray> rays, std::span<Hit> hits) {
    base::checkArgument(rays.size() == hits.size(), "hits: {} for {} rays", hits.size(), rays.size());
    forBlocks(rays.size(), [&](std::size_t first, std::size_t count) {
        world.closestHits(rays.subspan(first, count), 0.0f, hits.subspan(first, count));
    });
}

void castAny(const trace::World& world, std::span<const Ray> rays, std::span<std::uint8_t> occluded) {
    base::checkArgument(rays.size() == occluded.size(), "occluded: {} for {} rays", occluded.size(),
                        rays.size());
    forBlocks(rays.size(), [&](std::size_t first, std::size_t count) {
        world.anyHits(rays.subspan(first, count), 0.0f, occluded.subspan(first, count));
    });
}

std::vector<std::vector<Hit>> castAll(const trace::World& world, std::span<const Ray> rays) {
    std::vector<std::vector<Hit>> hits(rays.size());
    forBlocks(
        rays.size(),
        [&](std::size_t first, std::size_t count) {
            for (std::size_t i = first; i < first + count; ++i) world.crossings(rays[i], 0.0f, hits[i]);
        },
        1);
    return hits;
}

}  // namespace rayscope::render
