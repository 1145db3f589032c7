#include "base/read_file.h"

#include <rayscope/diagnostics.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace rayscope::base {

namespace {
[[noreturn]] void throwReason(const std::string& path, int error) {
    throw InputError("cannot be read: " + std::generic_category().message(error), {path});
}
}  // namespace

std::string readFile(const std::string& path, const ReadProgress& progress) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw InputError("is a folder, not a file", {path});

    const auto close = [](std::FILE* file) { std::fclose(file); };
    const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"));
    if (!file) throwReason(path, errno);

    std::string bytes;
    std::uintmax_t size = std::filesystem::file_size(path, ignored);
    if (ignored) size = 0;
    bytes.reserve(size);
    char block[1 << 16];
    while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) {
        bytes.append(block, count);
        if (progress) progress(bytes.size(), size);
    }
    if (std::ferror(file.get())) throwReason(path, errno);
    return bytes;
}

}  // namespace rayscope::base
