#pragma once
#include <rayscope/scene.h>

#include <span>

#include "scene/toml_values.h"

namespace rayscope::scene {

/// The keys of a texture table with `generate`, besides `wrap`.
std::span<const std::string_view> generatedTextureKeys();

/// Reads { generate = "checker", cells = [8, 8], colors = [a, b] } or
/// { generate = "texels", size = [2, 2], colors = [row by row from the top left] }.
RgbImage readGeneratedTexture(const TomlValue& value);

/// A latitude-longitude image of a clear sky with a sun over a plain, linear; (0, 0) is up and −z in the
/// middle.
RgbImage generateSky(int width, int height);

}  // namespace rayscope::scene
