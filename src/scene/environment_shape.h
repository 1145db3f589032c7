#pragma once
#include <rayscope/scene.h>

#include <string>
#include <vector>

namespace rayscope::scene {

/// One sentence per kind of probable mistake in the images: shapes that do not fit the sphere or the cube,
/// and images of a cube that were made for a left-handed one.
std::vector<std::string> environmentOddities(const Environment& environment);

}  // namespace rayscope::scene
