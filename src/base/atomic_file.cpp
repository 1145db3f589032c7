#include "base/atomic_file.h"

#include <fcntl.h>
#include <rayscope/diagnostics.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

#include "base/parse_number.h"
#include "base/temporary_files.h"

namespace rayscope::base {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void throwCannotWrite(const std::string& path, int error) {
    throw InputError("cannot be written: " + std::generic_category().message(error), {path});
}

/// `path`, or the target of a symbolic link at `path`, even if the target does not exist yet.
fs::path destinationOf(const std::string& path) {
    std::error_code error;
    const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : fs::path(path);
    return error ? fs::path(path) : target;
}

/// The number in names of open descriptors such as /dev/stdout and /dev/fd/3.
std::optional<int> descriptorNamed(const std::string& path) {
    if (path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"})
        if (path.starts_with(folder)) return parseInteger<int>(std::string_view(path).substr(folder.size()));
    return std::nullopt;
}

/// Whether there is something at `path` that cannot be replaced by a regular file.
bool isPipeOrDevice(const std::string& path) {
    if (descriptorNamed(path)) return true;
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

/// Returns false and sets errno unless all bytes were written.
bool writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) return false;
        if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

/// An open pipe or device.
class OpenDevice {
  public:
    explicit OpenDevice(const std::string& path) {
        if (const std::optional<int> number = descriptorNamed(path)) {
            // Opening it anew would begin at the first byte of a file again.
            std::fflush(stdout);
            descriptor_ = ::fcntl(*number, F_DUPFD_CLOEXEC, 0);
        } else {
            descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        }
    }
    OpenDevice(const OpenDevice&) = delete;
    OpenDevice& operator=(const OpenDevice&) = delete;
    ~OpenDevice() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    int descriptor() const { return descriptor_; }

  private:
    int descriptor_ = -1;
};

/// A temporary file for `target`. Throws InputError, with the position `path`, if its folder cannot hold one.
std::unique_ptr<TemporaryFile> createBeside(const fs::path& target, const std::string& path,
                                            FileAccess access = FileAccess::Default) {
    std::error_code ignored;
    if (fs::is_directory(target, ignored)) throw InputError("is a folder, not a file", {path});
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored))
        throw InputError("cannot be written: no folder '" + folder.string() + "'; create it first", {path});
    return std::make_unique<TemporaryFile>(folder, access == FileAccess::Owner ? 0600 : 0666);
}

}  // namespace

struct AtomicFile::State {
    State(const std::string& p, FileAccess a) : path(p), access(a) {
        if (path.empty()) throw InputError("the name of the file to write is empty");
        if (isPipeOrDevice(path)) {
            device = std::make_unique<OpenDevice>(path);
        } else {
            target = destinationOf(path);
            temporary = createBeside(target, path, access);
        }
        if (descriptor() < 0) throwCannotWrite(path, errno);
    }
    int descriptor() const { return device ? device->descriptor() : temporary->descriptor(); }

    /// Returns false and sets errno on failure.
    bool keepPermissions() const {
        struct stat old {};
        return access == FileAccess::Owner || ::stat(target.c_str(), &old) != 0 ||
               ::fchmod(temporary->descriptor(), old.st_mode & 07777) == 0;
    }

    std::string path;
    FileAccess access;
    fs::path target;
    std::unique_ptr<OpenDevice> device;
    std::unique_ptr<TemporaryFile> temporary;
};

AtomicFile::AtomicFile(const std::string& path, FileAccess access)
    : state_(std::make_unique<State>(path, access)) {}
AtomicFile::~AtomicFile() = default;

void AtomicFile::write(std::string_view bytes) {
    if (!writeAll(state_->descriptor(), bytes)) throwCannotWrite(state_->path, errno);
}

void AtomicFile::commit() {
    const State& s = *state_;
    if (s.temporary && !(s.keepPermissions() && s.temporary->moveTo(s.target)))
        throwCannotWrite(s.path, errno);
}

void writeFileAtomically(const std::string& path, std::string_view bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

void checkFileDestination(const std::string& path) {
    if (path.empty()) throw InputError("the name of the file to write is empty");
    if (isPipeOrDevice(path)) {
        const std::optional<int> number = descriptorNamed(path);
        const bool isOpen = number ? ::fcntl(*number, F_GETFD) != -1 : ::access(path.c_str(), W_OK) == 0;
        if (!isOpen) throwCannotWrite(path, errno);
        return;
    }
    // Creating a file is the only reliable check: permission bits do not cover read-only or full file
    // systems.
    if (createBeside(destinationOf(path), path)->descriptor() < 0) throwCannotWrite(path, errno);
}

}  // namespace rayscope::base
