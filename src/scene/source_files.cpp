#include "scene/source_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

#include "base/read_file.h"
#include "base/user_folders.h"
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

/// Folders of files that are too large to be embedded.
std::vector<fs::path> sceneFolders() {
    std::vector<fs::path> folders{RAYSCOPE_SOURCE_SCENES, RAYSCOPE_INSTALLED_SCENES};
    if (const fs::path cache = base::userCacheFolder(); !cache.empty()) folders.push_back(cache);
    return folders;
}

}  // namespace

bool fileExists(const std::string& path) {
    std::error_code ignored;
    return findEmbedded(path) || fs::is_regular_file(path, ignored);
}

std::string readSource(const std::string& path) {
    if (const auto* embedded = findEmbedded(path)) return std::string(embedded->content);
    return base::readFile(path);
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
