#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "fuzz/targets.h"
#include "support/temporary_folder.h"

namespace rayscope::test {

/// A file in a folder of its own, for parsers that read paths; in memory where the system has such a folder.
class MemoryFile {
  public:
    explicit MemoryFile(std::string_view name) : path_(folder_.file(name)) {}

    const std::string& path() const { return path_; }
    const TemporaryFolder& folder() const { return folder_; }

    /// Returns the path.
    const std::string& write(FuzzInput input) const {
        // Some file systems flush a file to the disk when it is overwritten.
        std::filesystem::remove(path_);
        std::ofstream(path_, std::ios::binary)
            .write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
        return path_;
    }

  private:
    TemporaryFolder folder_;
    std::string path_;
};

}  // namespace rayscope::test
