#pragma once
#include <cstdio>
#include <memory>
#include <string>

namespace rayscope::base {

/// All bytes of a file or pipe. Throws InputError with the path and the reason.
std::string readFile(const std::string& path);

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using FilePointer = std::unique_ptr<std::FILE, CloseFile>;

/// Opens a file or pipe for binary reading. Throws InputError with the path and the reason.
FilePointer openForReading(const std::string& path);

/// Reads the next bytes, at most `count`; fewer only at the end. Throws InputError with the path and the
/// reason.
std::size_t readBytes(std::FILE* file, const std::string& path, char* to, std::size_t count);

}  // namespace rayscope::base
