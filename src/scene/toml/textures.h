#pragma once
#include <rayscope/scene.h>

#include <span>

#include "scene/toml/values.h"

namespace rayscope::scene {

/// The keys of a texture table with `generate`, besides `wrap`.
std::span<const std::string_view> generatedTextureKeys();

/// Generates the image of { generate = "checker", cells = [8, 8], colors = [a, b] } or
/// { generate = "texels", size = [2, 2], colors = [row by row from the top left] }. Throws InputError.
RgbImage readGeneratedTexture(const TomlValue& value);

}  // namespace rayscope::scene
