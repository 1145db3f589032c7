#pragma once
#include <rayscope/settings.h>
#include <rayscope/vector.h>

namespace rayscope::sampling {

/// Standard normal deviate from a uniform number in [0, 1): the inverse of the cumulative distribution, so
/// that stratified input stays stratified. Relative error below 1e-15; finite for every float input.
double normalDeviate(float u);

/// A point in the unit aperture, uniform in area: the unit disk, its circumscribed square, or its inscribed
/// hexagon.
glm::dvec2 sampleAperture(LensShape shape, const glm::vec2& u);

}  // namespace rayscope::sampling
