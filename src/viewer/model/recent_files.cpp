#include "viewer/model/recent_files.h"

#include <rayscope/diagnostics.h>

#include <algorithm>
#include <sstream>

#include "base/private_file.h"
#include "base/user_folders.h"

namespace rayscope::viewer {

RecentFiles::RecentFiles(std::filesystem::path file) : file_(std::move(file)) {
    constexpr std::size_t kMaxBytes = kMaxCount * 4096;  // of paths that the system can open
    if (file_.empty()) return;
    try {
        std::istringstream stream(base::readPrivateFile(file_.string(), kMaxBytes).value_or(""));
        for (std::string line; paths_.size() < kMaxCount && std::getline(stream, line);)
            if (!line.empty()) paths_.push_back(line);
    } catch (const InputError&) {  // then the list is empty
    }
}

void RecentFiles::add(const std::string& scene) {
    const bool isFile = !scene.starts_with("builtin:");
    const std::string path = isFile ? std::filesystem::absolute(scene).lexically_normal().string() : scene;
    std::erase(paths_, path);
    paths_.insert(paths_.begin(), path);
    if (paths_.size() > kMaxCount) paths_.resize(kMaxCount);
    if (file_.empty()) return;
    std::string text;
    // A name with a line feed would be read as two.
    for (const std::string& line : paths_)
        if (line.find('\n') == std::string::npos) text += line + '\n';
    try {
        base::writePrivateFile(file_.string(), text);
    } catch (const InputError&) {  // then the list is not stored
    }
}

std::filesystem::path recentFilesPath() {
    const std::filesystem::path folder = base::userConfigFolder();
    return folder.empty() ? folder : folder / "recent";
}

}  // namespace rayscope::viewer
