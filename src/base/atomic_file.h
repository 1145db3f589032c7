#pragma once
#include <string>
#include <string_view>

namespace rayscope {

/// Writes a file whole or not at all: a temporary file in the same folder takes its place once all bytes are
/// in it; until then an old file of that name stays as it was. A symbolic link keeps its name and its target
/// is replaced; pipes and devices are written to directly. Throws InputError that names the file and the
/// reason.
void writeFileAtomically(const std::string& path, std::string_view bytes);

/// Throws InputError unless a file could be created at (or replaced under) this path now.
void checkFileDestination(const std::string& path);

}  // namespace rayscope
