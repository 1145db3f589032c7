#include "cli/help_text.h"

#include <fmt/format.h>

#include <string_view>

#include "cli/command_line.h"
#include "cli/option_value.h"

namespace rayscope::cli {

namespace {

constexpr std::size_t kHelpColumn = 30, kWidth = 100;

/// The text in lines of at most kWidth characters, each but the first indented.
std::string wrapped(std::string_view text, std::size_t indent) {
    std::string result;
    std::size_t column = indent;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, end);
        if (column > indent && column + 1 + word.size() > kWidth) {
            result += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (column > indent) {
            result += ' ';
            ++column;
        }
        result += word;
        column += word.size();
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return result;
}

std::string row(const std::string& head, std::string_view help) {
    std::string line = "  " + head;
    const bool fits = line.size() + 2 <= kHelpColumn;
    line += fits ? std::string(kHelpColumn - line.size(), ' ') : "\n" + std::string(kHelpColumn, ' ');
    return line + wrapped(help, kHelpColumn) + "\n";
}

}  // namespace

std::string headOf(const Option& option) {
    std::string head;
    for (const std::string_view name : option.nameList())
        head += (head.empty() ? "" : ", ") + std::string(name);
    if (option.isPositional()) return head;
    const std::string form = formOf(option);
    if (form.empty()) return head;
    return option.impliedValue ? fmt::format("{} [{}]", head, form) : fmt::format("{} {}", head, form);
}

std::string helpOf(const Option& option) {
    std::string text = option.help;
    if (const std::string expectation = expectationOf(option); !expectation.empty())
        text += fmt::format(" ({})", expectation);
    if (option.isRequired) text += "; required";
    if (option.showsDefault) text += fmt::format("; default {}", valueText(option));
    return text;
}

std::string usageOf(const Command& command, const OptionList& list) {
    std::string usage = fmt::format("rayscope {}", command.name);
    for (const Option& option : list.options()) {
        if (!option.isPositional()) continue;
        const bool isRepeated = std::holds_alternative<std::vector<std::string>*>(option.target);
        const std::string name = option.names + (isRepeated ? "…" : "");
        usage += option.isRequired ? " " + name : " [" + name + "]";
    }
    return usage + " [OPTIONS]";
}

std::string helpText(std::span<const Command> commands) {
    std::string text =
        "Rayscope, an interactive ray tracer that shows how each pixel is computed\n\n"
        "Usage: rayscope COMMAND [OPTIONS]\n       rayscope [SCENE]\n\nOptions:\n";
    text += row("-h, --help", "Print this text, or that of the command before it");
    text += row("--version", "Print the version, the compiler, the kernels and the libraries");
    text += "\nCommands:\n";
    for (const Command& command : commands) text += row(std::string(command.name), command.summary);
    return text;
}

std::string helpText(const Command& command, const OptionList& list) {
    std::string positionals, options;
    for (const Option& option : list.options())
        (option.isPositional() ? positionals : options) += row(headOf(option), helpOf(option));
    std::string text = fmt::format("{}\n\nUsage: {}\n", wrapped(command.summary, 0), usageOf(command, list));
    if (!positionals.empty()) text += "\nArguments:\n" + positionals;
    text += "\nOptions:\n" + row("-h, --help", "Print this text") + options;
    if (!list.details().empty()) text += "\n" + wrapped(list.details(), 0) + "\n";
    return text;
}

}  // namespace rayscope::cli
