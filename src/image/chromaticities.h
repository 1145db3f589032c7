#pragma once
#include <glm/mat3x3.hpp>

#include <array>
#include <optional>

namespace rayscope::image {

/// CIE x and y of red, green, blue and white.
using Chromaticities = std::array<float, 8>;

/// Those of ITU-R BT.709 and sRGB, with the white of D65.
inline constexpr Chromaticities kRec709{0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};

/// The matrix from linear values with the given primaries to those of kRec709; white stays white (chromatic
/// adaptation of Bradford). None if the primaries span no triangle.
std::optional<glm::dmat3> toRec709(const Chromaticities& from);

/// Whether they differ from kRec709 by no more than the digits in which files state them.
bool isRec709(const Chromaticities& chromaticities);

}  // namespace rayscope::image
