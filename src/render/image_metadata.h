#pragma once
#include <rayscope/image.h>
#include <rayscope/scene.h>
#include <rayscope/settings.h>

#include <cstdint>

namespace rayscope::render {

/// Name and version of the program.
std::string softwareName();

/// The metadata of an image file: program and version, scene, settings, seed, samples per pixel.
ImageMetadata imageMetadata(const SceneDescription& scene, const Settings& settings, std::uint64_t seed,
                            int samples);

}  // namespace rayscope::render
