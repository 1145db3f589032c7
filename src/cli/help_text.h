#pragma once
#include <span>
#include <string>

namespace rayscope::cli {

struct Command;
struct Option;
class OptionList;

/// What `rayscope --help` prints.
std::string helpText(std::span<const Command> commands);

/// What `rayscope COMMAND --help` prints. To be made before the options are parsed: it shows their defaults.
std::string helpText(const Command& command, const OptionList& list);

/// The first line of it, without "Usage: ": "rayscope render SCENE [OPTIONS]".
std::string usageOf(const Command& command, const OptionList& list);

/// What it prints of one option, on the left, such as "-t, --threads INTEGER", and on the right.
std::string headOf(const Option& option);
std::string helpOf(const Option& option);

}  // namespace rayscope::cli
