#pragma once
#include <rayscope/scene.h>

#include <string_view>

namespace rayscope::scene {

/// What leaves the picture of a camera undefined: the direction of the view or its rotation about it; "" if
/// nothing does.
std::string_view problemOf(const CameraDescription& camera);

}  // namespace rayscope::scene
