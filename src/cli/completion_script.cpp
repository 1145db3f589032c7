#include "cli/completion_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/command_line.h"
#include "cli/help_text.h"
#include "cli/option_value.h"
#include "cli/scene_options.h"

namespace rayscope::cli {

namespace {

/// What a shell offers for a value. A word that ends with = is to be continued.
struct Values {
    std::vector<std::string> words;
    bool files = false, folders = false;
};

Values valuesOf(const Option& option) {
    Values values;
    values.words = option.accepted;
    if (option.suggestions)
        for (std::string& word : option.suggestions()) values.words.push_back(std::move(word));
    values.folders = option.output == Option::Output::Folder;
    values.files = option.isInput || (option.output != Option::Output::None && !values.folders) ||
                   (option.isPositional() && option.accepted.empty());
    return values;
}

/// Every command with its options; --help is one of them.
template <class Visit>
void forEachCommand(std::span<const Command> commands, Visit visit) {
    for (const Command& command : commands) {
        OptionList list;
        bool help = false;
        list.add("-h,--help", &help, "Print the options of the command");
        const std::function<int()> owner = command.setUp(list);  // of the variables behind the options
        visit(command, list.options());
    }
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

constexpr std::string_view kBashEnd = R"(        *) expects_value= ;;
    esac
    [[ $expects_value ]] || case $current in
        -*) offered=($options) ;;
        *) offered=($arguments) files=$argument_files ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "${offered[*]}" -- "$current")
    [[ ${#COMPREPLY[@]} == 1 && $COMPREPLY == *= ]] && compopt -o nospace
    if [[ $files ]]; then
        mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -A "$files" -- "$current")
        compopt -o filenames
    fi
    # The shell replaces only what follows the last : or = of a word.
    local before=${current%"${current##*[:=]}"}
    COMPREPLY=("${COMPREPLY[@]#"$before"}")
}
complete -F _rayscope rayscope
)";

constexpr std::string_view kBashBegin =
    R"(# Completions of rayscope for bash, printed by: rayscope completions bash
_rayscope() {
    local line=${COMP_LINE:0:COMP_POINT} words command previous current expects_value=1 files=
    local options= arguments= argument_files= offered=()
    read -ra words <<<"$line"
    [[ $line == *[[:space:]] ]] && words+=('')
    command=${words[1]} current=${words[-1]} previous=${words[-2]}
    [[ $current == --*=* ]] && previous=${current%%=*} current=${current#*=}
)";

std::string_view bashFiles(const Values& values) {
    return values.files ? "file" : values.folders ? "directory" : "";
}

std::string bashScript(std::span<const Command> commands) {
    std::string names, branches, values;
    forEachCommand(commands, [&](const Command& command, const auto& options) {
        names += fmt::format(" {}", command.name);
        std::string optionNames, arguments, files;
        for (const Option& option : options) {
            const Values offered = valuesOf(option);
            if (option.isPositional()) {
                arguments = fmt::format("{}", fmt::join(offered.words, " "));
                files = bashFiles(offered);
                continue;
            }
            optionNames += fmt::format(" {}", fmt::join(option.nameList(), " "));
            if (option.isFlag()) continue;
            std::string patterns;
            for (const std::string_view name : option.nameList())
                patterns += fmt::format("{}'{} {}'", patterns.empty() ? "" : " | ", command.name, name);
            values += fmt::format("        {}) offered=({}) files={} ;;\n", patterns,
                                  fmt::join(offered.words, " "), bashFiles(offered));
        }
        branches += fmt::format("            {}) options='{}' arguments='{}' argument_files={} ;;\n",
                                command.name, optionNames.substr(1), arguments, files);
    });
    return fmt::format(
        "{}    if ((${{#words[@]}} == 2)); then\n        previous= options='--help --version' "
        "argument_files=file arguments='{} {}'\n    else\n        case $command in\n{}        esac\n    fi\n"
        "    case \"$command $previous\" in\n{}{}",
        kBashBegin, names.substr(1), fmt::join(builtinSceneNames(), " "), branches, values, kBashEnd);
}

std::string fishQuoted(std::string_view text) {
    return "'" + replaced(replaced(std::string(text), "\\", "\\\\"), "'", "\\'") + "'";
}

std::string fishValues(const Values& values) {
    std::string text = values.files     ? " -F"
                       : values.folders ? " -f -a '(__fish_complete_directories)'"
                                        : " -f";
    if (!values.words.empty()) text += " -a " + fishQuoted(fmt::format("{}", fmt::join(values.words, " ")));
    return text;
}

std::string fishScript(std::span<const Command> commands) {
    std::string text =
        "# Completions of rayscope for fish, printed by: rayscope completions fish\n"
        "complete -c rayscope -n __fish_use_subcommand -l help -s h -d 'Print the commands'\n"
        "complete -c rayscope -n __fish_use_subcommand -l version -d 'Print the version'\n";
    text += fmt::format("complete -c rayscope -n __fish_use_subcommand -a {}\n",
                        fishQuoted(fmt::format("{}", fmt::join(builtinSceneNames(), " "))));
    forEachCommand(commands, [&](const Command& command, const auto& options) {
        text += fmt::format("complete -c rayscope -n __fish_use_subcommand -a {} -d {}\n", command.name,
                            fishQuoted(command.summary));
        bool takesFiles = false;
        for (const Option& option : options) {
            const Values values = valuesOf(option);
            takesFiles = takesFiles || (option.isPositional() && values.files);
            text += fmt::format("complete -c rayscope -n '__fish_seen_subcommand_from {}'", command.name);
            for (const std::string_view name : option.nameList()) {
                if (name.starts_with("--"))
                    text += fmt::format(" -l {}", name.substr(2));
                else if (name.starts_with('-'))
                    text += fmt::format(" -s {}", name.substr(1));
            }
            if (!option.isPositional() && !option.isFlag() && !option.impliedValue) text += " -r";
            if (!option.isFlag()) text += fishValues(values);
            text += fmt::format(" -d {}\n", fishQuoted(option.help));
        }
        if (!takesFiles)
            text +=
                fmt::format("complete -c rayscope -n '__fish_seen_subcommand_from {}' -f\n", command.name);
    });
    return text;
}

/// The text in a single-quoted specification of _arguments or _describe.
std::string zshEscaped(std::string text) {
    for (const char* const special : {"\\", ":", "[", "]"})
        text = replaced(text, special, std::string("\\") + special);
    return replaced(text, "'", "'\\''");
}

/// The action of a specification.
std::string zshAction(const Values& values) {
    std::vector<std::string> whole, begun;
    for (const std::string& word : values.words)
        (word.ends_with('=') ? begun : whole).push_back(zshEscaped(word));
    std::string action;
    if (!whole.empty()) action += fmt::format("compadd -- {}; ", fmt::join(whole, " "));
    if (!begun.empty()) action += fmt::format("compadd -S \"\" -- {}; ", fmt::join(begun, " "));
    if (values.files) action += "_files; ";
    if (values.folders) action += "_files -/; ";
    return action.empty() ? " " : fmt::format("{{ {}}}", action);
}

std::string zshSpecification(const Option& option) {
    const std::string form = option.isPositional() ? option.names : formOf(option);
    const std::string value = option.isFlag() ? ""
                                              : fmt::format("{}:{}:{}", option.impliedValue ? ":" : "",
                                                            zshEscaped(form), zshAction(valuesOf(option)));
    const bool isRepeated = std::holds_alternative<std::vector<std::string>*>(option.target);
    if (option.isPositional()) return fmt::format("'{}{}'", isRepeated ? "*" : "", value);
    const std::vector<std::string_view> names = option.nameList();
    std::string spellings;
    for (const std::string_view name : names) {
        const std::string_view mark = option.isFlag() ? "" : name.starts_with("--") ? "=" : "+";
        spellings += fmt::format("{}{}{}", spellings.empty() ? "" : ",", name, mark);
    }
    const std::string group = isRepeated ? "'*'" : fmt::format("'({})'", fmt::join(names, " "));
    return fmt::format("{}{}'[{}]{}'", group, names.size() > 1 ? "{" + spellings + "}" : spellings,
                       zshEscaped(option.help), value);
}

std::string zshScript(std::span<const Command> commands) {
    std::string names, branches;
    forEachCommand(commands, [&](const Command& command, const auto& options) {
        names += fmt::format("        '{}:{}'\n", command.name, zshEscaped(std::string(command.summary)));
        branches += fmt::format("        {})\n            _arguments -s -S", command.name);
        for (const Option& option : options) branches += " \\\n                " + zshSpecification(option);
        branches += "\n            ;;\n";
    });
    return fmt::format(
        "#compdef rayscope\n# Completions of rayscope for zsh, printed by: rayscope completions zsh\n"
        "_rayscope() {{\n    local -a commands=(\n{}    )\n    if (( CURRENT == 2 )); then\n"
        "        _describe -t commands command commands\n        compadd -- --help --version {}\n        "
        "_files\n"
        "        return\n    fi\n    local command=$words[2]\n    shift words\n    (( CURRENT-- ))\n"
        "    case $command in\n{}        *) _files ;;\n    esac\n}}\n"
        "if [[ $funcstack[1] == _rayscope ]]; then _rayscope \"$@\"; else compdef _rayscope rayscope; fi\n",
        names, fmt::join(builtinSceneNames(), " "), branches);
}

}  // namespace

std::string completionScript(std::span<const Command> commands, std::string_view shell) {
    if (shell == "bash") return bashScript(commands);
    if (shell == "fish") return fishScript(commands);
    return zshScript(commands);
}

}  // namespace rayscope::cli
