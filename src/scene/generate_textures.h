#pragma once
#include <rayscope/scene.h>

#include <span>

#include "scene/toml_values.h"

namespace rayscope::scene {

/// The keys of a texture table with `generate`, besides `wrap`.
std::span<const std::string_view> generatedTextureKeys();

/// Generates the image of { generate = "checker", cells = [8, 8], colors = [a, b] } or
/// { generate = "texels", size = [2, 2], colors = [row by row from the top left] }. Throws InputError.
RgbImage readGeneratedTexture(const TomlValue& value);

/// A linear latitude-longitude image of a clear sky with a sun above a plain; the top row is up, the centre
/// is −z.
RgbImage generateSky(int width, int height);

}  // namespace rayscope::scene
