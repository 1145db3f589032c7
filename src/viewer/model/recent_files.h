#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace rayscope::viewer {

/// The most recently opened scenes, newest first, stored in a text file with one path per line. If the file
/// cannot be read or written, the list is not stored; there is no error.
class RecentFiles {
  public:
    explicit RecentFiles(std::filesystem::path file);
    void add(const std::string& scene);
    const std::vector<std::string>& paths() const { return paths_; }

    static constexpr std::size_t kMaxCount = 10;

  private:
    std::filesystem::path file_;
    std::vector<std::string> paths_;
};

/// $XDG_CONFIG_HOME/rayscope/recent, or ~/.config/rayscope/recent; empty if there is no home.
std::filesystem::path recentFilesPath();

}  // namespace rayscope::viewer
