#pragma once
#include <span>
#include <string>

namespace rayscope::cli {

struct Command;
class OptionList;

/// What `rayscope --help` prints.
std::string helpText(std::span<const Command> commands);

/// What `rayscope COMMAND --help` prints. To be made before the options are parsed: it shows their defaults.
std::string helpText(const Command& command, const OptionList& list);

}  // namespace rayscope::cli
