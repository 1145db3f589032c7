#include "cli/usage.h"

#include <fmt/format.h>

#include "base/nearest_name.h"

namespace rayscope::cli {

namespace {

const CLI::App& commandOf(const CLI::App& program) {
    const auto chosen = program.get_subcommands();
    return chosen.empty() ? program : *chosen.front();
}

std::vector<std::string> optionNames(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

}  // namespace

std::string usageError(const CLI::App& program, const CLI::ParseError& error,
                       const std::vector<std::string>& arguments) {
    const CLI::App& command = commandOf(program);
    const std::vector<std::string> names = optionNames(command);
    const std::vector<std::string_view> known(names.begin(), names.end());
    for (const std::string& argument : arguments) {
        const std::string name = argument.substr(0, argument.find('='));
        const bool option = name.starts_with("--") && name.size() > 2;
        if (option && std::find(known.begin(), known.end(), name) == known.end())
            return fmt::format("unknown option '{}' of '{}'{}", name, command.get_name(),
                               base::didYouMean(name, known));
    }
    return error.what();
}

}  // namespace rayscope::cli
