#include "base/console.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/completion_script.h"
#include "cli/manual_page.h"

namespace rayscope::cli {

std::function<int()> setUpManual(OptionList& list) {
    list.setDetails("Show it with: rayscope manual | man -l -");
    return [] {
        base::writeOutput(manualPage(commandTable()));
        return kSuccess;
    };
}

std::function<int()> setUpCompletions(OptionList& list) {
    auto shell = std::make_shared<std::string>();
    list.add("SHELL", shell.get(), "The shell: bash, fish or zsh")
        .choices({"bash", "fish", "zsh"})
        .required();
    list.setDetails(
        "Installed packages have the files in the folders where shells look. For one session: "
        "source <(rayscope completions bash)");
    return [shell] {
        base::writeOutput(completionScript(commandTable(), *shell));
        return kSuccess;
    };
}

}  // namespace rayscope::cli
