#pragma once
// The grammar of the command line: which argument is a command, an option, a value or a positional argument.
#include <span>
#include <string>
#include <vector>

namespace rayscope::cli {

struct Command;
struct Option;
class OptionList;

/// The arguments divided into the command and the rest.
struct CommandArguments {
    const Command* command = nullptr;  ///< null: --help or --version, or nothing at all
    bool wantsHelp = false, wantsVersion = false;
    std::vector<std::string> rest;
};

/// Finds the command. A scene without a command means `view`, if there is such a command. Throws UsageError
/// for a name that is neither a command nor a scene.
CommandArguments findCommand(std::span<const Command> commands, const std::vector<std::string>& arguments);

/// Sets the variables of the options from the arguments after the command. Returns false, without setting
/// all, if the arguments ask for --help. Throws UsageError.
bool parseOptions(const Command& command, const OptionList& list, const std::vector<std::string>& arguments);

}  // namespace rayscope::cli
