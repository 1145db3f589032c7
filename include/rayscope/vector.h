#pragma once
// The one door through which GLM enters.
#include <glm/glm.hpp>

namespace rayscope {

/// A linear colour or radiance with the primaries of sRGB (Rec. 709). Not a spectrum.
using Rgb = glm::vec3;

/// A sum of many colours: double, so that 10^8 addends lose nothing that shows.
using RgbSum = glm::dvec3;

}  // namespace rayscope
