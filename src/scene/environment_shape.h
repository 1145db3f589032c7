#pragma once
#include <rayscope/scene.h>
#include <array>
#include <string_view>

#include <string>
#include <vector>

namespace rayscope::scene {

/// The keys of the faces of a cube, in the order of Environment::cube.
inline constexpr std::array<std::string_view, 6> kCubeFaces{"px", "nx", "py", "ny", "pz", "nz"};

/// One sentence per kind of probable mistake in the images: shapes that do not fit the sphere or the cube,
/// and images of a cube that were made for a left-handed one.
std::vector<std::string> environmentOddities(const Environment& environment);

}  // namespace rayscope::scene
