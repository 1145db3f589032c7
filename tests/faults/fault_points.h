#pragma once
// Allocations and starts of threads that fail on request, anywhere in the process: in the program, in the C++
// library and in the libraries that it uses.
#include <cstdint>

namespace rayscope::test {

enum class FaultKind { Allocation, Thread };

/// The calls of one kind from arm() on are counted, by all threads. Memory that is shared with child
/// processes holds the count, so that a parent can read that of a child.
struct FaultPoints {
    /// Fails call number `point`, from 1 on, and with `andAllAfter` all later ones; 0: none fails.
    static void arm(FaultKind kind, std::uint64_t point, bool andAllAfter);
    static void disarm();
    /// Calls since arm(), here or in a child process.
    static std::uint64_t count();
};

}  // namespace rayscope::test
