#pragma once
#include <rayscope/scene.h>
#include <string>
#include <string_view>

namespace rayscope::viewer {

/// The camera as options of the command line: "--look-from 0,0,3 --look-at 0,0,0 --up 0,1,0 --fov 50". The
/// numbers are the shortest that give the same float.
std::string toOptions(const CameraDescription& camera);

/// Sets the values that the options in `text` name and keeps the others. Throws InputError with the expected
/// form.
CameraDescription withOptions(const CameraDescription& camera, std::string_view text);

}  // namespace rayscope::viewer
