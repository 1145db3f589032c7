#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "faults/fault_points.h"
#include "support/temporary_folder.h"

namespace rayscope::test {

/// What fails during a command.
struct Fault {
    FaultKind kind = FaultKind::Allocation;
    std::uint64_t point = 0;  ///< see FaultPoints::arm()
    bool andAllAfter = false;
};

struct CommandOutcome {
    int status = 0;  ///< the exit code, or 128 and the number of the signal
    std::string out, err;
    std::uint64_t calls = 0;  ///< of the kind of the fault
};

/// Runs a command of the program as main() does, in a child process with the folder as the working directory.
/// A child that takes longer than some minutes ends by SIGALRM.
CommandOutcome runForked(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                         const Fault& fault);

}  // namespace rayscope::test
