// The program: one sub-command per job. Errors of every kind end here, as one line on stderr and an exit
// code.
#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <algorithm>
#include <clocale>
#include <csignal>
#include <new>

#include "cli/commands.h"
#include "cli/usage.h"
#include "render/crash_report.h"

namespace rayscope::cli {

namespace {

/// `rayscope SCENE` means `rayscope view SCENE`.
std::vector<std::string> withDefaultCommand(const CLI::App& program, std::vector<std::string> arguments) {
    const auto isProgramOption = [](const std::string& a) {
        return a == "--help" || a == "-h" || a == "--version";
    };
    const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
    const auto knows = [&](const std::string& name) {
        return std::ranges::any_of(commands,
                                   [&](const CLI::App* command) { return command->get_name() == name; });
    };
    const bool named = !arguments.empty() && knows(arguments.front());
    const bool hasView = knows("view");
    if (hasView && !named && (arguments.empty() || !isProgramOption(arguments.front())))
        arguments.insert(arguments.begin(), "view");
    return arguments;
}

int runProgram(std::vector<std::string> arguments) {
    CLI::App program{"Rayscope, an interactive ray tracer that shows what it does", "rayscope"};
    program.set_version_flag("--version", "rayscope " RAYSCOPE_VERSION);
    program.require_subcommand(1);
    program.failure_message(CLI::FailureMessage::simple);
    int exitCode = kSuccess;
#ifdef RAYSCOPE_VIEWER
    addViewCommand(program, exitCode);
#endif
    addRenderCommand(program, exitCode);
    addProbeCommand(program, exitCode);
    addInfoCommand(program, exitCode);
    addBenchCommand(program, exitCode);
    addCastCommand(program, exitCode);
    addTradeCommand(program, exitCode);
    addLabCommand(program, exitCode);
    addCompareCommand(program, exitCode);
    addSettingsCommand(program, exitCode);

    arguments = withDefaultCommand(program, std::move(arguments));
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    try {
        program.parse(reversed);
        return exitCode;
    } catch (const CLI::Success& success) {  // --help and --version
        return program.exit(success);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr,
                   "error: {}\nRun 'rayscope --help' for the commands and 'rayscope COMMAND --help' for "
                   "their options.\n",
                   usageError(program, error, arguments));
        return kUsageError;
    }
}

}  // namespace

}  // namespace rayscope::cli

int main(int argc, char** argv) {
    // A limit on the size of files should fail a write, as a full disk does, not end the program.
    std::signal(SIGXFSZ, SIG_IGN);
    rayscope::render::installCrashReport();
    try {
        return rayscope::cli::runProgram(std::vector<std::string>(argv + 1, argv + argc));
    } catch (const rayscope::InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "error: out of memory; try a smaller --size or a smaller scene\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "error: {}\n", error.what());
    }
    return rayscope::cli::kInputError;
}
