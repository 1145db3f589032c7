#pragma once
#include <cstdint>
#include <functional>
#include <string>

namespace rayscope::base {

/// Called with the number of bytes read so far and the size of the file, 0 if it has none (a pipe). May throw
/// to end the reading.
using ReadProgress = std::function<void(std::uintmax_t done, std::uintmax_t total)>;

/// All bytes of a file or pipe. Throws InputError with the path and the reason. `progress` is called for each
/// block.
std::string readFile(const std::string& path, const ReadProgress& progress = {});

}  // namespace rayscope::base
