#include "base/read_file.h"

#include <rayscope/diagnostics.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "base/memory_budget.h"
#include "base/printable_text.h"

namespace rayscope::base {

namespace {
[[noreturn]] void throwCannotRead(const std::string& path, int error) {
    // Readers that go on without a file, such as a texture, must not do so for lack of memory.
    if (error == ENOMEM) throwOutOfMemoryWhile("reading " + printable(path), "a smaller scene");
    throw InputError("cannot be read: " + std::generic_category().message(error), {path});
}
}  // namespace

FilePointer openForReading(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw InputError("is a folder, not a file", {path});
    FilePointer file(std::fopen(path.c_str(), "rb"));
    if (!file) throwCannotRead(path, errno);
    return file;
}

std::size_t readBytes(std::FILE* file, const std::string& path, char* to, std::size_t count) {
    const std::size_t read = std::fread(to, 1, count, file);
    if (read < count && std::ferror(file)) throwCannotRead(path, errno);
    return read;
}

std::string readFile(const std::string& path, const ReadProgress& progress) {
    const FilePointer file = openForReading(path);
    std::error_code unknownSize;
    std::string bytes;
    const auto expected = std::filesystem::file_size(path, unknownSize);
    const std::uintmax_t size = unknownSize ? 0 : expected;
    requireMemory(size, "a smaller file", "the file {}", printable(path));
    bytes.reserve(size);
    char block[1 << 16];
    while (const std::size_t count = readBytes(file.get(), path, block, sizeof block)) {
        if (bytes.capacity() - bytes.size() < count)
            requireMemory(2 * bytes.capacity(), "a smaller file", "the file {}", printable(path));
        bytes.append(block, count);
        if (progress) progress(bytes.size(), size);
    }
    return bytes;
}

}  // namespace rayscope::base
