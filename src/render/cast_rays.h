#pragma once
#include <rayscope/ray.h>
#include <cstdint>
#include <span>

#include "trace/world.h"

namespace rayscope::render {

/// Answers many rays on the threads of the calling arena, at the start of the shutter; the answers are those
/// of World::closestHit() and World::anyHit(). Both spans have the same length.
void castClosest(const trace::World& world, std::span<const Ray> rays, std::span<Hit> hits);
void castAny(const trace::World& world, std::span<const Ray> rays, std::span<std::uint8_t> occluded);

}  // namespace rayscope::render
