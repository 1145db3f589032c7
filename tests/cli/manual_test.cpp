// The manual page and the completions name every command and every option of the tables.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/completion_script.h"
#include "cli/help_text.h"
#include "cli/manual_page.h"

namespace rayscope::cli {
namespace {

using testing::HasSubstr;

/// `visit` gets each command and its options; the variables that they set exist during the call.
template <class Visit>
void forCommands(Visit visit) {
    for (const Command& command : commandTable()) {
        OptionList list;
        const std::function<int()> run = command.setUp(list);
        visit(command, list);
    }
}

/// The text that a reader of the manual page sees.
std::string withoutEscapes(std::string page) {
    for (const char* const escape : {"\\&", "\\"})
        for (std::size_t at; (at = page.find(escape)) != std::string::npos;)
            page.erase(at, std::string_view(escape).size());
    return page;
}

/// The part of the text from `begin` to the next `end`.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t first = text.find(begin);
    if (first == std::string::npos) return "";
    return text.substr(first, text.find(end, first + begin.size()) - first);
}

TEST(ManualPage, ListsWhatHelpLists) {
    const std::string page = withoutEscapes(manualPage(commandTable()));
    forCommands([&](const Command& command, const OptionList& list) {
        const std::string section = between(page, ".SS " + usageOf(command, list) + "\n", "\n.S");
        ASSERT_NE(section, "") << command.name;
        EXPECT_THAT(section, HasSubstr(std::string(command.summary)));
        EXPECT_THAT(section, HasSubstr(list.details()));
        for (const Option& option : list.options())
            EXPECT_THAT(section + "\n", HasSubstr(".B " + headOf(option) + "\n" + helpOf(option) + "\n"));
    });
    for (const char* const code : {"0", "1", "2", "3", "4", "5", "130"})
        EXPECT_THAT(between(page, ".SH EXIT STATUS\n", ".SH"), HasSubstr(std::string(".B ") + code + "\n"));
}

TEST(ManualPage, NoLineIsARequestByAccident) {
    const std::string page = manualPage(commandTable());
    for (std::size_t begin = 0; begin < page.size();) {
        const std::string line = page.substr(begin, page.find('\n', begin) - begin);
        EXPECT_THAT(line, testing::Not(testing::StartsWith("'")));
        if (line.starts_with('.')) {
            EXPECT_THAT(line, testing::ContainsRegex("^\\.(\\\\\"|TH |SH |SS |PP$|TP$|B |I |br$)"));
        }
        begin += line.size() + 1;
    }
}

/// The part of a script that completes the options of one command.
std::string partOf(const std::string& script, std::string_view shell, std::string_view command) {
    const std::string name(command);
    if (shell == "bash") return between(script, "            " + name + ") options=", ";;");
    if (shell == "zsh") return between(script, "        " + name + ")\n", ";;");
    std::string lines;
    const std::string begin = "complete -c rayscope -n '__fish_seen_subcommand_from " + name + "'";
    for (std::size_t at = 0; (at = script.find(begin, at)) != std::string::npos; ++at)
        lines += script.substr(at, script.find('\n', at) - at) + "\n";
    return lines;
}

std::string spelled(std::string_view option, std::string_view shell) {
    if (shell != "fish") return std::string(option);
    return option.starts_with("--") ? " -l " + std::string(option.substr(2)) + " "
                                    : " -s " + std::string(option.substr(1)) + " ";
}

TEST(CompletionScripts, NameEveryOption) {
    for (const char* const shell : {"bash", "fish", "zsh"}) {
        const std::string script = completionScript(commandTable(), shell);
        forCommands([&](const Command& command, const OptionList& list) {
            const std::string part = partOf(script, shell, command.name);
            ASSERT_NE(part, "") << shell << " " << command.name;
            for (const Option& option : list.options()) {
                if (option.isPositional()) continue;
                for (const std::string_view name : option.nameList())
                    EXPECT_THAT(part, HasSubstr(spelled(name, shell))) << shell << " " << command.name;
            }
        });
    }
}

}  // namespace
}  // namespace rayscope::cli
