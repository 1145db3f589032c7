#include "cli/arguments.h"

#include <fmt/format.h>

#include <rayscope/scene.h>
#include <algorithm>
#include <filesystem>
#include <map>

#include "base/nearest_name.h"
#include "base/printable_text.h"
#include "cli/command_line.h"
#include "cli/option_value.h"

namespace rayscope::cli {

namespace {

bool isHelp(std::string_view argument) { return argument == "--help" || argument == "-h"; }

bool existsAsFile(const std::string& name) {
    std::error_code ignored;
    return std::filesystem::exists(name, ignored);
}

/// Whether an argument without a command may be meant as a scene for `view`.
bool looksLikeScene(const std::string& argument) {
    return argument.starts_with('-') || argument.find_first_of(".:/") != std::string::npos ||
           existsAsFile(argument);
}

[[noreturn]] void throwUnknownCommand(std::span<const Command> commands, const std::string& name) {
    std::vector<std::string_view> known;
    for (const Command& command : commands) known.push_back(command.name);
    std::string hint = base::didYouMean(name, known);
    for (const BuiltinScene& scene : builtinScenes())
        if (scene.name == name) hint = fmt::format(" (the built-in scene is 'builtin:{}')", name);
    if (hint.empty()) hint = ", and there is no file of this name";
    throw UsageError(fmt::format("unknown command {}{}", base::quoted(name), hint));
}

/// Reads the arguments of one command from left to right.
class OptionParser {
  public:
    OptionParser(const Command& command, const OptionList& list, const std::vector<std::string>& arguments)
        : command_(command), arguments_(arguments) {
        for (const Option& option : list.options()) {
            if (option.isPositional()) positionals_.push_back(&option);
            for (const std::string_view name : option.nameList()) byName_.emplace(name, &option);
        }
    }

    bool parse() {
        bool optionsEnded = false;
        while (next_ < arguments_.size()) {
            const std::string& argument = arguments_[next_++];
            if (optionsEnded || argument.size() < 2 || argument.front() != '-')
                takePositional(argument);
            else if (argument == "--")
                optionsEnded = true;
            else if (isHelp(argument))
                return false;
            else if (argument.starts_with("--"))
                takeLong(argument);
            else
                takeShort(argument);
        }
        checkRequired();
        return true;
    }

  private:
    const Option* find(std::string_view name) const {
        const auto found = byName_.find(name);
        return found == byName_.end() ? nullptr : found->second;
    }

    void set(const Option& option, std::string_view text) {
        const bool mayRepeat =
            option.isFlag() || std::holds_alternative<std::vector<std::string>*>(option.target);
        if (++given_[&option] > 1 && !mayRepeat)
            throw UsageError(fmt::format("{} is given twice", option.mainName()));
        // The first value replaces the defaults.
        if (auto* const* texts = std::get_if<std::vector<std::string>*>(&option.target);
            texts && given_[&option] == 1)
            (*texts)->clear();
        if (text.empty() && !option.isFlag())
            throw UsageError(std::string(option.mainName()), "the value is empty");
        setValue(option, text);
    }

    /// The value after the name of an option.
    std::string_view takeValue(const Option& option) {
        const bool hasNext = next_ < arguments_.size();
        const std::string_view following = hasNext ? std::string_view(arguments_[next_]) : "";
        const bool isOption = following.size() > 1 && following.starts_with('-') &&
                              (following == "--" || isHelp(following) ||
                               find(following.substr(0, following.find('='))) != nullptr);
        if (option.impliedValue && (!hasNext || following.starts_with('-'))) return *option.impliedValue;
        if (!hasNext || isOption) {
            const std::string expectation = expectationOf(option);
            throw UsageError(std::string(option.mainName()),
                             fmt::format("a value is missing; expected {}",
                                         expectation.empty() ? formOf(option) : expectation));
        }
        ++next_;
        return following;
    }

    void takePositional(const std::string& argument) {
        if (argument.empty()) throw UsageError("an argument is empty");
        if (positionals_.empty())
            throw UsageError(fmt::format("unexpected argument {}", base::quoted(argument)));
        const bool isRepeated =
            std::holds_alternative<std::vector<std::string>*>(positionals_.back()->target);
        if (taken_ == positionals_.size() && !isRepeated) {
            const Option& last = *positionals_.back();
            throw UsageError(fmt::format("unexpected argument {} after {} {}", base::quoted(argument),
                                         last.mainName(), base::quoted(valueText(last))));
        }
        set(*positionals_[std::min(taken_, positionals_.size() - 1)], argument);
        taken_ = std::min(taken_ + 1, positionals_.size());
    }

    void takeLong(const std::string& argument) {
        const std::size_t equals = argument.find('=');
        const std::string name = argument.substr(0, equals);
        const Option* option = find(name);
        if (!option) throwUnknown(argument, name);
        if (option->isFlag() && equals != std::string::npos) throw UsageError(name, "takes no value");
        if (option->isFlag())
            set(*option, "");
        else if (equals != std::string::npos)
            set(*option, std::string_view(argument).substr(equals + 1));
        else
            set(*option, takeValue(*option));
    }

    /// "-q", "-t4", "-t=4", "-t 4", and flags in one argument.
    void takeShort(const std::string& argument) {
        for (std::size_t i = 1; i < argument.size(); ++i) {
            const std::string name{'-', argument[i]};
            const Option* option = find(name);
            if (!option) throwUnknown(argument, i == 1 ? argument : name);
            if (option->isFlag()) {
                set(*option, "");
                continue;
            }
            std::string_view value = std::string_view(argument).substr(i + 1);
            if (value.starts_with('=')) value.remove_prefix(1);
            set(*option, i + 1 == argument.size() ? takeValue(*option) : value);
            return;
        }
    }

    [[noreturn]] void throwUnknown(const std::string& argument, const std::string& name) const {
        std::vector<std::string_view> known{"--help"};
        for (const auto& [text, option] : byName_)
            if (text.starts_with("--")) known.push_back(text);
        std::string hint = base::didYouMean(name, known);
        if (existsAsFile(argument) || (hint.empty() && argument.find('.') != std::string::npos))
            hint = fmt::format("; for a file of this name write {}", base::quoted("./" + argument));
        throw UsageError(fmt::format("unknown option {} of '{}'{}", base::quoted(name), command_.name, hint));
    }

    void checkRequired() const {
        for (const auto& [option, name] : requiredOptions())
            if (!given_.contains(option)) throw UsageError(fmt::format("{} is required", name));
    }
    std::vector<std::pair<const Option*, std::string>> requiredOptions() const {
        std::vector<std::pair<const Option*, std::string>> list;
        for (const Option* option : positionals_)
            if (option->isRequired) list.emplace_back(option, option->names);
        for (const auto& [name, option] : byName_)
            if (option->isRequired && !option->isPositional() && name == option->mainName())
                list.emplace_back(option, std::string(name));
        return list;
    }

    const Command& command_;
    const std::vector<std::string>& arguments_;
    std::map<std::string_view, const Option*> byName_;
    std::vector<const Option*> positionals_;
    std::map<const Option*, int> given_;
    std::size_t next_ = 0, taken_ = 0;
};

}  // namespace

std::vector<std::string_view> Option::nameList() const {
    std::vector<std::string_view> list;
    for (std::string_view rest = names; !rest.empty();) {
        const std::size_t end = std::min(rest.find(','), rest.size());
        list.push_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return list;
}

std::string_view Option::mainName() const {
    const std::vector<std::string_view> list = nameList();
    const auto found =
        std::find_if(list.begin(), list.end(), [](std::string_view name) { return name.starts_with("--"); });
    return found == list.end() ? list.front() : *found;
}

CommandArguments findCommand(std::span<const Command> commands, const std::vector<std::string>& arguments) {
    const auto commandNamed = [&](std::string_view name) -> const Command* {
        const auto found = std::find_if(commands.begin(), commands.end(),
                                        [&](const Command& command) { return command.name == name; });
        return found == commands.end() ? nullptr : &*found;
    };
    CommandArguments result;
    const Command* const view = commandNamed("view");
    if (arguments.empty()) {
        result.command = view;
        return result;
    }
    const std::string& first = arguments.front();
    if (first.empty()) throw UsageError("an argument is empty; expected a command or a scene");
    result.wantsHelp = isHelp(first);
    result.wantsVersion = first == "--version";
    if (result.wantsHelp || result.wantsVersion) return result;
    result.command = commandNamed(first);
    result.rest.assign(arguments.begin() + (result.command ? 1 : 0), arguments.end());
    if (result.command) return result;
    for (const std::string& argument : arguments)
        if (first.starts_with('-') && commandNamed(argument))
            throw UsageError(fmt::format("the command comes first: rayscope {} …", argument));
    if (!looksLikeScene(first)) throwUnknownCommand(commands, first);
    if (!view) throw UsageError("a command is required, such as 'render': this build has no window");
    result.command = view;
    return result;
}

bool parseOptions(const Command& command, const OptionList& list, const std::vector<std::string>& arguments) {
    return OptionParser(command, list, arguments).parse();
}

}  // namespace rayscope::cli
