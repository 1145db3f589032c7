#pragma once
#include <rayscope/accel.h>
#include <span>

#include "bvh/bounds.h"
#include "bvh/intersect/ray_query.h"

namespace rayscope::bvh {

/// Fewer primitives than this are not worth a task of their own while a tree is built.
constexpr std::size_t kTaskSize = 4096;

/// The boxes of all primitives with finite coordinates, in ascending order of their numbers.
struct PrimitiveRefs {
    base::BigVector<PrimitiveRef> refs;
    std::uint32_t dropped = 0;  ///< primitives with NaN or infinite coordinates
};

/// Throws std::invalid_argument with the number of the first triangle that names a vertex that does not
/// exist, and std::length_error if there are more primitives than a tree can number.
PrimitiveRefs collectPrimitiveRefs(const AccelInput& input, const std::stop_token& stop);

/// Around a triangle or, numbered after all triangles, a sphere.
PrimitiveBox boxOfPrimitive(const AccelInput& input, std::size_t primitive);

/// Whether all coordinates are finite.
bool hasFiniteCoordinates(const AccelInput& input, std::size_t primitive);

/// How many primitives are not.
std::size_t countNonFinitePrimitives(const AccelInput& input, const std::stop_token& stop);

/// Throws std::invalid_argument with the number of the first triangle that names a vertex that does not
/// exist.
void checkIndices(const AccelInput& input, const std::stop_token& stop);

}  // namespace rayscope::bvh
