#pragma once
#include <rayscope/image.h>
#include <rayscope/render_session.h>

namespace rayscope::render {

/// Name and version of the program.
std::string softwareName();

/// The metadata of an image file: program and version, scene, camera, settings, seed, samples per pixel.
ImageMetadata imageMetadata(const RenderRequest& request, int samples);

}  // namespace rayscope::render
