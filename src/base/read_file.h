#pragma once
#include <string>

namespace rayscope::base {

/// All bytes of a file or pipe. Throws InputError with the path and the reason.
std::string readFile(const std::string& path);

}  // namespace rayscope::base
