#pragma once
#include <functional>
#include <span>

namespace rayscope::cli {

struct Command;
class OptionList;

/// Exit codes that scripts rely on.
enum ExitCode : int {
    kSuccess = 0,
    kUsageError = 1,
    kInputError = 2,
    kStoppedByLimit = 3,
    kThresholdExceeded = 4,
    kNonFiniteImage = 5,
    kInterrupted = 130
};

/// All commands of the program, in the order of --help.
std::span<const Command> commandTable();

/// Command::setUp of each command.
using CommandSetUp = std::function<int()>(OptionList& options);
CommandSetUp setUpView, setUpRender, setUpMerge, setUpProbe, setUpInfo, setUpBench, setUpCast, setUpTrade,
    setUpLab, setUpCompare, setUpSettings, setUpFetch, setUpManual, setUpCompletions;

}  // namespace rayscope::cli
