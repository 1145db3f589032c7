#pragma once
#include <string>

namespace rayscope::base {

/// All bytes of a file. Throws InputError that names the file and the reason.
std::string readFile(const std::string& path);

}  // namespace rayscope::base
