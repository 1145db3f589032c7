#include "cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "base/nearest_name.h"
#include "cli/commands.h"

namespace rayscope::cli {

namespace {

/// A command, its options and its parser.
struct ParsedCommand {
    CLI::App* parser;
    OptionList options;
    std::function<int()> run;
};

void addCheck(CLI::Option& parsed, const Option::Check& check) {
    if (const auto* whole = std::get_if<std::pair<int, int>>(&check))
        parsed.check(CLI::Range(whole->first, whole->second));
    else if (const auto* real = std::get_if<std::pair<double, double>>(&check))
        parsed.check(CLI::Range(real->first, real->second));
    else if (const auto* sign = std::get_if<Option::Sign>(&check))
        parsed.check(*sign == Option::Sign::Positive ? CLI::Validator(CLI::PositiveNumber)
                                                     : CLI::Validator(CLI::NonNegativeNumber));
    else if (const auto* texts = std::get_if<std::vector<std::string>>(&check))
        parsed.check(CLI::IsMember(*texts));
}

template <class Value>
CLI::Option* addTo(CLI::App& parser, const Option& option, Value& value) {
    return parser.add_option(option.names, value, option.help);
}
CLI::Option* addTo(CLI::App& parser, const Option& option, bool& value) {
    return parser.add_flag(option.names, value, option.help);
}
CLI::Option* addTo(CLI::App& parser, const Option& option, std::vector<std::string>& values) {
    CLI::Option* parsed = parser.add_option(option.names, values, option.help);
    // Otherwise the option would take the positional arguments after it, too.
    if (option.names.starts_with("-")) parsed->take_all()->expected(1)->allow_extra_args(false);
    return parsed;
}

void add(CLI::App& parser, const Option& option) {
    CLI::Option* parsed =
        std::visit([&](auto* value) { return addTo(parser, option, *value); }, option.target);
    addCheck(*parsed, option.check);
    parsed->required(option.isRequired);
    if (option.separator != 0) parsed->delimiter(option.separator);
    if (option.showsDefault) parsed->capture_default_str();
    if (option.impliedValue) parsed->expected(0, 1)->default_str(*option.impliedValue);
}

std::vector<std::string> optionNames(const CLI::App& parser) {
    std::vector<std::string> names;
    for (const CLI::Option* option : parser.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

/// One line: the first unknown option with the nearest name, else the parser's message.
std::string describe(const CLI::ParseError& error, const CLI::App& program,
                     const std::vector<std::string>& arguments) {
    const auto chosen = program.get_subcommands();
    const CLI::App& parser = chosen.empty() ? program : *chosen.front();
    const std::vector<std::string> names = optionNames(parser);
    const std::vector<std::string_view> known(names.begin(), names.end());
    for (const std::string& argument : arguments) {
        const std::string name = argument.substr(0, argument.find('='));
        const bool isOption = name.starts_with("--") && name.size() > 2;
        if (isOption && std::find(known.begin(), known.end(), name) == known.end())
            return fmt::format("unknown option '{}' of '{}'{}", name, parser.get_name(),
                               base::didYouMean(name, known));
    }
    return error.what();
}

int printUsageError(const std::string& message) {
    fmt::print(stderr,
               "error: {}\nRun 'rayscope --help' for the commands and 'rayscope COMMAND --help' for their "
               "options.\n",
               message);
    return kUsageError;
}

}  // namespace

int runCommandLine(std::span<const Command> commands, const std::vector<std::string>& arguments) {
    CLI::App program{"Rayscope, an interactive ray tracer that shows how each pixel is computed", "rayscope"};
    program.set_version_flag("--version", "rayscope " RAYSCOPE_VERSION);
    program.require_subcommand(1);
    std::deque<ParsedCommand> parsed;
    for (const Command& command : commands) {
        ParsedCommand& p = parsed.emplace_back();
        p.parser = program.add_subcommand(std::string(command.name), std::string(command.summary));
        p.run = command.setUp(p.options);
        for (const Option& option : p.options.options()) add(*p.parser, option);
        p.parser->footer(p.options.details());
    }
    try {
        program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::Success& success) {  // --help and --version
        return program.exit(success);
    } catch (const CLI::ParseError& error) {
        return printUsageError(describe(error, program, arguments));
    }
    const auto chosen =
        std::ranges::find_if(parsed, [](const ParsedCommand& p) { return p.parser->parsed(); });
    try {
        return chosen->run();
    } catch (const UsageError& error) {
        return printUsageError(error.what());
    }
}

}  // namespace rayscope::cli
