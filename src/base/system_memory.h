#pragma once
// What the system says about memory. All sizes are in bytes.
#include <cstdint>
#include <filesystem>

namespace rayscope::base {

/// The memory of the machine.
std::uint64_t physicalMemory();

/// The smallest limit of the control group of the process and of the groups above it, of version 1 or 2;
/// kNoMemoryLimit if there is none. `root` is the folder with proc and sys.
std::uint64_t controlGroupMemory(const std::filesystem::path& root = "/");

/// The memory that the process uses.
struct MemoryUse {
    std::uint64_t resident = 0;      ///< in physical memory
    std::uint64_t allocated = 0;     ///< by the C library, touched or not
    std::uint64_t addressSpace = 0;  ///< what RLIMIT_AS limits
    std::uint64_t dataSegment = 0;   ///< what RLIMIT_DATA limits
};
MemoryUse memoryUse();

}  // namespace rayscope::base
