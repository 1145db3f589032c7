#pragma once
#include <string>

namespace rayscope::cli {

/// What `rayscope --version` prints: "rayscope VERSION", then a line each for the compiler and the type of
/// the build, the kernels of the wide BVH layout, and the libraries with the versions that the build found.
std::string versionText();

}  // namespace rayscope::cli
