#pragma once
// Files that exist until they are moved to their destination, and the names of those that have one, so that a
// signal handler can delete them.
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>

namespace rayscope::base {

/// Remembers a file for removeTemporaryFiles() during its lifetime. It does not delete it.
class TemporaryName {
  public:
    explicit TemporaryName(const std::string& path);
    ~TemporaryName();
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;

  private:
    int slot_;  ///< -1: the table is full, or the path too long
};

/// Deletes the remembered files. Async-signal-safe: for handlers that end the program.
void removeTemporaryFiles() noexcept;

/// A new file in a folder, deleted by the destructor unless it was moved. Where the file system can hold
/// files without a name it has none before moveTo(), so that nothing is left however the program ends.
class TemporaryFile {
  public:
    enum class Kind { UnnamedIfPossible, Named };

    /// `mode` is limited by the umask. On failure descriptor() is -1, and errno says why.
    TemporaryFile(std::filesystem::path folder, mode_t mode, Kind kind = Kind::UnnamedIfPossible);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    int descriptor() const { return descriptor_; }

    /// Closes the file and moves it to `target` in the same folder, where it replaces another file. Returns
    /// false and sets errno on failure.
    bool moveTo(const std::filesystem::path& target);

  private:
    template <class Create>
    bool createUnderNewName(Create&& create);
    void openNamed(mode_t mode);
    bool giveName();
    bool copyToNamed(int unnamed);

    std::filesystem::path folder_, path_;
    int descriptor_ = -1;
    std::optional<TemporaryName> name_;  ///< while the file has one
};

}  // namespace rayscope::base
