#pragma once
#include <rayscope/ray.h>
#include <cstdint>
#include <span>
#include <vector>

#include "trace/world.h"

namespace rayscope::render {

/// World::closestHits() and World::anyHits() at the start of the shutter, in parallel on the threads of the
/// calling arena. Both spans have the same length, else
/// std::invalid_argument is thrown.
void castClosest(const trace::World& world, std::span<const Ray> rays, std::span<Hit> hits);
void castAny(const trace::World& world, std::span<const Ray> rays, std::span<std::uint8_t> occluded);

/// The hits of ray i, in order, for all rays.
std::vector<std::vector<Hit>> castAll(const trace::World& world, std::span<const Ray> rays);

}  // namespace rayscope::render
