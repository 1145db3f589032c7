#include "base/temporary_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <utility>

namespace rayscope::base {

namespace {

/// A handler may interrupt any instruction: it reads a path only while the slot is Set.
enum SlotState : int { Free, Busy, Set };
struct Slot {
    std::atomic<int> state{Free};
    char path[4096];
};
static_assert(std::atomic<int>::is_always_lock_free);
std::array<Slot, 32> slots;

int occupySlot(const std::string& path) {
    if (path.size() >= sizeof Slot::path) return -1;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        int expected = Free;
        if (!slots[i].state.compare_exchange_strong(expected, Busy)) continue;
        std::memcpy(slots[i].path, path.c_str(), path.size() + 1);
        slots[i].state = Set;
        return static_cast<int>(i);
    }
    return -1;
}

/// Hidden, and different from those of other runs, which may have the same process number.
std::string newName() {
    static std::atomic<std::uint64_t> serial{0};
    std::uint64_t random = 0;
    if (::getentropy(&random, sizeof random) != 0) random = static_cast<std::uint64_t>(::getpid()) << 32;
    return fmt::format(".rayscope-{:016x}.tmp", random + serial++);
}

std::string linkTo(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

}  // namespace

TemporaryName::TemporaryName(const std::string& path) : slot_(occupySlot(path)) {}
TemporaryName::~TemporaryName() {
    if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].state = Free;
}

void removeTemporaryFiles() noexcept {
    for (const Slot& slot : slots)
        if (slot.state == Set) ::unlink(slot.path);
}

TemporaryFile::TemporaryFile(std::filesystem::path folder, mode_t mode, Kind kind)
    : folder_(std::move(folder)) {
    if (folder_.empty()) folder_ = ".";
    if (kind == Kind::UnnamedIfPossible) {
        descriptor_ = ::open(folder_.c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, mode);
        // Without /proc an unnamed file cannot get a name.
        if (descriptor_ >= 0 && ::access(linkTo(descriptor_).c_str(), F_OK) != 0)
            ::close(std::exchange(descriptor_, -1));
    }
    if (descriptor_ < 0) openNamed(mode);
}

TemporaryFile::~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (name_) ::unlink(path_.c_str());
}

/// Calls create() with path_ set to new names until it does not fail with EEXIST. The name is remembered
/// before the file exists.
template <class Create>
bool TemporaryFile::createUnderNewName(Create&& create) {
    constexpr int kAttempts = 100;
    for (int i = 0; i < kAttempts; ++i) {
        path_ = folder_ / newName();
        name_.emplace(path_.string());
        if (create()) return true;
        const int error = errno;
        name_.reset();
        errno = error;
        if (error != EEXIST) break;
    }
    return false;
}

void TemporaryFile::openNamed(mode_t mode) {
    createUnderNewName([&] {
        descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        return descriptor_ >= 0;
    });
}

bool TemporaryFile::giveName() {
    const std::string file = linkTo(descriptor_);
    const auto link = [&] {
        return ::linkat(AT_FDCWD, file.c_str(), AT_FDCWD, path_.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    // Some file systems can create unnamed files, but not name them.
    return createUnderNewName(link) || copyToNamed(std::exchange(descriptor_, -1));
}

bool TemporaryFile::copyToNamed(int unnamed) {
    struct stat status {};
    bool isCopied = ::fstat(unnamed, &status) == 0;
    if (isCopied) openNamed(status.st_mode & 07777);
    isCopied &= descriptor_ >= 0 && ::fchmod(descriptor_, status.st_mode & 07777) == 0;
    off_t offset = 0;
    while (isCopied && offset < status.st_size)
        isCopied =
            ::sendfile(descriptor_, unnamed, &offset, static_cast<std::size_t>(status.st_size - offset)) > 0;
    const int error = errno;
    ::close(unnamed);
    errno = error;
    return isCopied;
}

bool TemporaryFile::moveTo(const std::filesystem::path& target) {
    if (!name_ && !giveName()) return false;
    // Network file systems may report a full disk only here.
    if (::close(std::exchange(descriptor_, -1)) != 0) return false;
    if (::rename(path_.c_str(), target.c_str()) != 0) return false;
    name_.reset();
    return true;
}

}  // namespace rayscope::base
