#pragma once
#include <rayscope/render_session.h>

namespace rayscope::render {

/// Throws std::invalid_argument, with the name of the member, if the scene is null, the image has no pixels
/// or more than kMaxImagePixels, the region is empty or not within the image, a setting is out of range, or
/// for what scene::checkReferences() finds.
void checkRequest(const RenderRequest& request);

}  // namespace rayscope::render
