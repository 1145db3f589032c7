#pragma once
#include <CLI/CLI.hpp>

namespace rayscope::cli {

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

/// Each adds one sub-command to the program; running it sets the exit code.
void addViewCommand(CLI::App& program, int& exitCode);
void addRenderCommand(CLI::App& program, int& exitCode);
void addProbeCommand(CLI::App& program, int& exitCode);
void addInfoCommand(CLI::App& program, int& exitCode);
void addBenchCommand(CLI::App& program, int& exitCode);
void addCastCommand(CLI::App& program, int& exitCode);
void addLabCommand(CLI::App& program, int& exitCode);
void addTradeCommand(CLI::App& program, int& exitCode);
void addCompareCommand(CLI::App& program, int& exitCode);
void addSettingsCommand(CLI::App& program, int& exitCode);

}  // namespace rayscope::cli
