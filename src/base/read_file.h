#pragma once
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

namespace rayscope::base {

/// Called with the number of bytes read so far and the size of the file, 0 if it has none (a pipe). May throw
/// to end the reading.
using ReadProgress = std::function<void(std::uintmax_t done, std::uintmax_t total)>;

/// All bytes of a file or pipe. Throws InputError with the path and the reason, and OutOfMemory. `progress`
/// is called for each block.
std::string readFile(const std::string& path, const ReadProgress& progress = {});

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
