#pragma once
#include <rayscope/accel.h>
#include <span>

#include "bvh/bounds.h"
#include "bvh/intersect/ray_query.h"

namespace rayscope::bvh {

/// The smallest number of primitives for a parallel task while a tree is built.
constexpr std::size_t kTaskSize = 4096;

/// The boxes of all primitives with finite coordinates, in ascending order of their numbers.
struct PrimitiveRefs {
    base::BigVector<PrimitiveRef> refs;
    std::uint32_t dropped = 0;  ///< primitives with NaN or infinite coordinates
};

/// Throws std::invalid_argument for the first triangle with an invalid vertex index, and std::length_error if
/// there are more primitives than node numbers allow.
PrimitiveRefs collectPrimitiveRefs(const AccelInput& input, const std::stop_token& stop);

/// Throws std::length_error if there are more primitives than node numbers allow.
void checkPrimitiveCount(const AccelInput& input);

/// The box of a triangle or, numbered after all triangles, a sphere.
PrimitiveBox boxOfPrimitive(const AccelInput& input, std::size_t primitive);

/// Whether all coordinates are finite.
bool hasFiniteCoordinates(const AccelInput& input, std::size_t primitive);

/// The number of primitives with NaN or infinite coordinates.
std::size_t countNonFinitePrimitives(const AccelInput& input, const std::stop_token& stop);

/// Throws std::invalid_argument for the first triangle with an invalid vertex index.
void checkIndices(const AccelInput& input, const std::stop_token& stop);

}  // namespace rayscope::bvh
