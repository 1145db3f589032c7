#include "base/private_file.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "base/atomic_file.h"
#include "base/read_file.h"

namespace rayscope::base {

namespace {

namespace fs = std::filesystem;

/// A folder that cannot be created is reported by the file in it.
void createPrivateFolders(const fs::path& folder) {
    std::error_code ignored;
    if (folder.empty() || fs::exists(folder, ignored)) return;
    createPrivateFolders(folder.parent_path());
    ::mkdir(folder.c_str(), 0700);
}

}  // namespace

void writePrivateFile(const std::string& path, std::string_view bytes) {
    createPrivateFolders(fs::path(path).parent_path());
    AtomicFile file(path, FileAccess::Owner);
    file.write(bytes);
    file.commit();
}

std::optional<std::string> readPrivateFile(const std::string& path, std::size_t maxBytes) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
        throw InputError("cannot be read: " + std::generic_category().message(errno), {path});
    }
    if (!S_ISREG(status.st_mode)) throw InputError("is not a regular file", {path});
    if (status.st_uid != ::geteuid()) throw InputError("belongs to another user", {path});
    if ((status.st_mode & (S_IWGRP | S_IWOTH)) != 0) throw InputError("can be written by others", {path});
    if (static_cast<std::uintmax_t>(status.st_size) > maxBytes)
        throw InputError(fmt::format("has {} bytes, more than {}", status.st_size, maxBytes), {path});
    return readFile(path);
}

}  // namespace rayscope::base
