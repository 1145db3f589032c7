#pragma once
#include <span>
#include <string>
#include <string_view>

namespace rayscope::cli {

struct Command;

/// The script that completes commands, options and values in the shell "bash", "fish" or "zsh".
std::string completionScript(std::span<const Command> commands, std::string_view shell);

}  // namespace rayscope::cli
