#include "viewer/model/recent_files.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace rayscope::viewer {

RecentFiles::RecentFiles(std::filesystem::path file) : file_(std::move(file)) {
    std::ifstream stream(file_);
    for (std::string line; paths_.size() < kMaxCount && std::getline(stream, line);)
        if (!line.empty()) paths_.push_back(line);
}

void RecentFiles::add(const std::string& scene) {
    const bool isFile = !scene.starts_with("builtin:");
    const std::string path = isFile ? std::filesystem::absolute(scene).lexically_normal().string() : scene;
    std::erase(paths_, path);
    paths_.insert(paths_.begin(), path);
    if (paths_.size() > kMaxCount) paths_.resize(kMaxCount);
    if (file_.empty()) return;
    std::error_code ignored;
    std::filesystem::create_directories(file_.parent_path(), ignored);
    std::ofstream stream(file_);
    for (const std::string& line : paths_) stream << line << '\n';
}

std::filesystem::path recentFilesPath() {
    const char* config = std::getenv("XDG_CONFIG_HOME");
    if (config != nullptr && config[0] != '\0') return std::filesystem::path(config) / "rayscope" / "recent";
    const char* home = std::getenv("HOME");
    if (home == nullptr || home[0] == '\0') return {};
    return std::filesystem::path(home) / ".config" / "rayscope" / "recent";
}

}  // namespace rayscope::viewer
