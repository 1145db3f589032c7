#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace rayscope::viewer {

/// The scenes that were opened last, newest first, kept in a text file with one path per line. A file that
/// cannot be read or written costs the memory, never an error.
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
