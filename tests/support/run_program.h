#pragma once
// Runs the program as a user would: a process with its own folder.
#include <stdlib.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace rayscope::test {

/// A folder that is removed at the end.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string pattern = std::filesystem::temp_directory_path() / "rayscope-XXXXXX";
        path_ = mkdtemp(pattern.data());
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }
    void write(const std::string& name, const std::string& content) const {
        std::ofstream(path_ / name) << content;
    }

  private:
    std::filesystem::path path_;
};

inline std::string readText(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

struct ProgramResult {
    int exitCode = -1;
    std::string out, err;
};

/// `command` is passed to the shell with the folder as the working directory; "rayscope" in it is the
/// program.
inline ProgramResult run(const TemporaryFolder& folder, std::string command) {
    const std::string program = "rayscope";
    if (command.starts_with(program))
        command.replace(0, program.size(), std::string("'") + RAYSCOPE_PROGRAM + "'");
    const std::string line = "cd '" + folder.path().string() + "' && { " + command + "; } >.out 2>.err";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), readText(folder / ".out"),
            readText(folder / ".err")};
}

}  // namespace rayscope::test
