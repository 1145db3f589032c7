#pragma once
// Vector types; the public headers include GLM through this file only.
#include <glm/glm.hpp>

namespace rayscope {

/// A linear colour or radiance with the primaries of sRGB (ITU-R BT.709).
using Rgb = glm::vec3;

/// A sum of colours in double precision, so that the rounding of 10^8 terms stays invisible.
using RgbSum = glm::dvec3;

}  // namespace rayscope
