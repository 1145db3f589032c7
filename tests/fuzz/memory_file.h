#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace rayscope::test {

/// A folder in memory with one file, for parsers that read paths.
class MemoryFile {
  public:
    explicit MemoryFile(const std::string& name) {
        std::string folder = "/dev/shm/rayscope-fuzz-XXXXXX";
        if (!::mkdtemp(folder.data())) std::abort();
        folder_ = folder;
        path_ = folder + "/" + name;
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() { std::filesystem::remove_all(folder_); }

    const std::string& write(const std::uint8_t* data, std::size_t size) const {
        std::ofstream(path_, std::ios::binary)
            .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
        return path_;
    }

  private:
    std::string folder_, path_;
};

}  // namespace rayscope::test
