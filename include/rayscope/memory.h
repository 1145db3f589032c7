#pragma once
#include <cstdint>
#include <limits>
#include <new>
#include <string_view>

namespace rayscope {

/// Memory ran out: the system has no more, or what is needed would exceed memoryLimit(). `what()` is one line
/// for the user, "out of memory: WHAT needs 2.1 GB, but …; ADVICE", without "error:". Where it is thrown
/// nothing is half done: objects keep their state, and files are not written.
class OutOfMemory : public std::bad_alloc {
  public:
    /// Copies the message without allocating; what does not fit is cut off.
    explicit OutOfMemory(std::string_view message) noexcept;
    const char* what() const noexcept override { return text_; }

  private:
    char text_[480];
};

inline constexpr std::uint64_t kNoMemoryLimit = std::numeric_limits<std::uint64_t>::max();

/// Limits the memory of the process to this many bytes; kNoMemoryLimit: no limit of its own. Meshes, BVHs,
/// films, images and other large arrays are checked against it before they are allocated, and throw
/// OutOfMemory. What is allocated already stays. May be called from any thread.
void setMemoryLimit(std::uint64_t bytes);

/// The limit in bytes. By default 80 % of the memory of the machine or, if it is less, of the control group.
std::uint64_t memoryLimit();

/// The number of bytes that can still be allocated: within memoryLimit() and within the limits of the system
/// for the process (RLIMIT_AS, RLIMIT_DATA).
std::uint64_t availableMemory();

}  // namespace rayscope
