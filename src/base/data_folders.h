#pragma once
#include <filesystem>
#include <vector>

namespace rayscope::base {

/// The folders that may hold Rayscope's data, such as scenes/ and scripts/, in the order in which they are
/// searched; they need not exist:
///   - share/rayscope in the folder of the program, which a build folder has
///   - the folder where the installation puts data, found from that of the program: ../share/rayscope
///   - userDataFolder()
///   - rayscope in each folder of $XDG_DATA_DIRS (else /usr/local/share and /usr/share); relative ones are
///     ignored, as the XDG Base Directory Specification says
/// No path of the build is part of them, so an installation may be moved.
std::vector<std::filesystem::path> dataFolders();

/// The first file `name`, relative to one of dataFolders(), that exists; else an empty path.
std::filesystem::path findDataFile(const std::filesystem::path& name);

}  // namespace rayscope::base
