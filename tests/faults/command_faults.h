#pragma once
// Every point of a command at which something may fail, one run for each.
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "faults/fault_points.h"

namespace rayscope::test {

/// A command with small input, and what it writes.
struct FaultyCommand {
    std::string name;
    std::vector<std::string> arguments;
    std::vector<std::string> outputs;   ///< the same bytes in every run
    std::vector<std::string> others{};  ///< outputs that hold times, and folders
    bool sameText = true;               ///< the standard output is the same in every run
    int otherCode = 0;                  ///< another exit code of success
};
void PrintTo(const FaultyCommand& command, std::ostream* to);
const std::vector<FaultyCommand>& faultyCommands();
/// Those that start threads.
std::vector<FaultyCommand> commandsWithThreads();

/// Runs the command once without a fault and then with a fault at each of at most `most` points, spread over
/// all of them. Expects that every run ends in success, with the output of the first run, or in exit code 2
/// with a message that names the reason; and that no temporary file, no other file and no file with other
/// content than in the first run is left.
void expectClearEnds(const FaultyCommand& command, FaultKind kind, std::uint64_t most);

}  // namespace rayscope::test
