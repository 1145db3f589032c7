#pragma once
// Where the files of a scene come from: the disk, or the program itself. A path "builtin:NAME" names a file
// that was compiled in; every reader of this room goes through these functions, so embedded scenes need no
// special case.
#include <rayscope/diagnostics.h>

#include <string>

namespace rayscope::scene {

/// The whole file. Throws InputError if it cannot be read.
std::string readSource(const std::string& path);

bool fileExists(const std::string& path);

/// The path of `name` as written in the file `base`: relative to its folder, with \ read as /. Names in
/// embedded files mean embedded files first, then files in the scenes folder of the source tree, of the
/// installation and in the user's cache folder.
std::string resolvePath(const std::string& base, std::string name);

}  // namespace rayscope::scene
