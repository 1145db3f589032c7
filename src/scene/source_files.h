#pragma once
// Access to the files of a scene, on disk or embedded in the program. A path "builtin:NAME" names an embedded
// file; all readers of this module use these functions, so that embedded scenes need no special case.
#include <rayscope/scene.h>

#include <string>

namespace rayscope::scene {

/// All bytes of the file. Throws InputError with the path and the reason, and Stopped. The step is called
/// "reading NAME".
std::string readSource(const std::string& path, const LoadControl& control = {});

/// Whether there is a regular file at the path.
bool fileExists(const std::string& path);

/// Throws InputError if the path names a pipe, a socket or a device, from which reading may never end.
void refuseSpecialFile(const std::string& path);

/// The path of a file `name` that the file `base` refers to: relative to the folder of `base`, with \ read as
/// /. References in embedded files are searched among the embedded files, then in the folder scenes/ of
/// base::dataFolders(); if the file does not exist, the path is that in the user's data folder.
std::string resolvePath(const std::string& base, std::string name);

}  // namespace rayscope::scene
