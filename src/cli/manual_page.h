#pragma once
#include <span>
#include <string>

namespace rayscope::cli {

struct Command;

/// The manual page rayscope(1) in the language of man(7), with every command and option.
std::string manualPage(std::span<const Command> commands);

}  // namespace rayscope::cli
