#pragma once
#include <rayscope/scene.h>

#include <string>
#include <string_view>

#include "scene/oddities.h"

namespace rayscope::scene {

/// The text of a file, in UTF-8 without byte order mark, with '\n' for each CR that stands alone (CR LF
/// stays). UTF-16 is recognised by its byte order mark or its zero bytes. Bytes that are not UTF-8 are read
/// as Windows-1252, and zero bytes as blanks; both are added to `oddities`. `format` names what is expected,
/// e.g. "OBJ". Throws InputError, which says what the file is, for compressed and binary files, web pages and
/// files of other formats, and for folders, pipes and devices, and Stopped.
std::string readTextFile(const std::string& path, std::string_view format, Oddities& oddities,
                         const LoadControl& control);

}  // namespace rayscope::scene
