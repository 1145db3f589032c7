#include "cli/command_line.h"

#include "base/console.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/help_text.h"
#include "cli/output_files.h"
#include "cli/version_text.h"

namespace rayscope::cli {

namespace {

int printUsageError(const std::string& message) {
    constexpr std::size_t kLongestMessage = 490;
    base::printMessage(
        "error: {}\nRun 'rayscope --help' for the commands and 'rayscope COMMAND --help' for their "
        "options.\n",
        base::shortened(base::printable(message), kLongestMessage));
    return kUsageError;
}

int parseAndRun(std::span<const Command> commands, const std::vector<std::string>& arguments) {
    const CommandArguments found = findCommand(commands, arguments);
    if (found.wantsVersion) {
        base::print("{}", versionText());
        return kSuccess;
    }
    if (!found.command && !found.wantsHelp) throw UsageError("a command is required");
    if (found.wantsHelp) {
        base::print("{}", helpText(commands));
        return kSuccess;
    }
    OptionList list;
    const std::function<int()> run = found.command->setUp(list);
    const std::string help = helpText(*found.command, list);
    if (!parseOptions(*found.command, list, found.rest)) {
        base::print("{}", help);
        return kSuccess;
    }
    checkDestinations(list);
    return run();
}

}  // namespace

int runCommandLine(std::span<const Command> commands, const std::vector<std::string>& arguments) {
    try {
        return parseAndRun(commands, arguments);
    } catch (const UsageError& error) {
        return printUsageError(error.what());
    }
}

}  // namespace rayscope::cli
