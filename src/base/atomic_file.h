#pragma once
#include <memory>
#include <string>
#include <string_view>

namespace rayscope::base {

/// Who may access a file that is written.
enum class FileAccess {
    Default,  ///< the permissions of the file that is replaced, or those that the umask leaves
    Owner     ///< nobody but the user
};

/// Creates or replaces a file atomically: writes a temporary file in the same folder and renames it. The
/// target of a symbolic link is replaced, not the link; pipes and devices are written to directly. Throws
/// InputError with the file and the reason.
void writeFileAtomically(const std::string& path, std::string_view bytes);

/// writeFileAtomically() in several pieces, for content that does not fit in memory: write() any number of
/// times, then commit(). Without commit() an existing file stays unchanged.
class AtomicFile {
  public:
    explicit AtomicFile(const std::string& path, FileAccess access = FileAccess::Default);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes);
    void commit();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Throws InputError unless a file can be created or replaced at this path now.
void checkFileDestination(const std::string& path);

}  // namespace rayscope::base
