#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace rayscope::cli {

/// What is wrong with a command line, in one line that names the nearest option or command there is.
std::string usageError(const CLI::App& program, const CLI::ParseError& error,
                       const std::vector<std::string>& arguments);

}  // namespace rayscope::cli
