#include "scene/source_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

#include "embedded_scenes.h"

namespace rayscope::scene {

namespace {

namespace fs = std::filesystem;
constexpr std::string_view kBuiltin = "builtin:";

const scenes::EmbeddedFile* findEmbedded(std::string_view path) {
    if (!path.starts_with(kBuiltin)) return nullptr;
    path.remove_prefix(kBuiltin.size());
    const auto files = scenes::files();
    const auto found =
        std::find_if(files.begin(), files.end(), [&](const auto& f) { return f.name == path; });
    return found == files.end() ? nullptr : &*found;
}

/// Folders that may hold files too large to be compiled in.
std::vector<fs::path> sceneFolders() {
    std::vector<fs::path> folders{RAYSCOPE_SOURCE_SCENES, RAYSCOPE_INSTALLED_SCENES};
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
        folders.push_back(fs::path(cache) / "rayscope");
    else if (const char* home = std::getenv("HOME"); home && *home)
        folders.push_back(fs::path(home) / ".cache" / "rayscope");
    return folders;
}

}  // namespace

bool fileExists(const std::string& path) {
    std::error_code ignored;
    return findEmbedded(path) || fs::is_regular_file(path, ignored);
}

std::string readSource(const std::string& path) {
    if (const auto* embedded = findEmbedded(path)) return std::string(embedded->content);
    std::error_code error;
    if (fs::is_directory(path, error)) throw InputError("cannot be read: it is a folder", {path});
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw InputError(fmt::format("cannot be opened: {}", std::strerror(errno)), {path});
    std::string content;
    if (const auto size = fs::file_size(path, error); !error) content.resize(size);
    stream.read(content.data(), static_cast<std::streamsize>(content.size()));
    content.resize(static_cast<std::size_t>(stream.gcount()));
    // A pipe has no size, and a file may grow while it is read.
    char chunk[1 << 16];
    while (stream.read(chunk, sizeof chunk) || stream.gcount() > 0)
        content.append(chunk, static_cast<std::size_t>(stream.gcount()));
    if (stream.bad()) throw InputError("cannot be read to its end", {path});
    return content;
}

std::string resolvePath(const std::string& base, std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.starts_with(kBuiltin) || fs::path(name).is_absolute()) return name;
    if (!base.starts_with(kBuiltin)) return (fs::path(base).parent_path() / name).lexically_normal().string();
    if (const std::string embedded = std::string(kBuiltin) + name; findEmbedded(embedded)) return embedded;
    const std::vector<fs::path> folders = sceneFolders();
    for (const fs::path& folder : folders)
        if (const std::string path = (folder / name).string(); fileExists(path)) return path;
    return (folders.front() / name).string();
}

}  // namespace rayscope::scene
