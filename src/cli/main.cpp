// The program. Errors of every kind end here or in runCommandLine(), as one line on stderr and an exit code.
#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <algorithm>
#include <csignal>
#include <new>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "render/crash_report.h"

namespace rayscope::cli {

namespace {

/// `rayscope SCENE` means `rayscope view SCENE`.
std::vector<std::string> withDefaultCommand(std::vector<std::string> arguments) {
    const auto isCommand = [](std::string_view name) {
        return std::ranges::any_of(commandTable(), [&](const Command& c) { return c.name == name; });
    };
    const auto isProgramOption = [](std::string_view a) {
        return a == "--help" || a == "-h" || a == "--version";
    };
    const bool isComplete =
        !arguments.empty() && (isCommand(arguments.front()) || isProgramOption(arguments.front()));
    if (!isComplete && isCommand("view")) arguments.insert(arguments.begin(), "view");
    return arguments;
}

}  // namespace

}  // namespace rayscope::cli

int main(int argc, char** argv) {
    using namespace rayscope;
    // A limit on the size of files should fail a write, as a full disk does, not end the program.
    std::signal(SIGXFSZ, SIG_IGN);
    render::installCrashReport();
    try {
        return cli::runCommandLine(cli::commandTable(), cli::withDefaultCommand({argv + 1, argv + argc}));
    } catch (const InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
    } catch (const Stopped&) {
        return cli::kInterrupted;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "error: out of memory; try a smaller --size or a smaller scene\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "error: {}\n", error.what());
    }
    return cli::kInputError;
}
