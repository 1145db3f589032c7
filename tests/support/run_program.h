#pragma once
// Runs the program as a user would: a process with its own folder.
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "support/temporary_folder.h"

namespace rayscope::test {

struct ProgramResult {
    int exitCode = -1;
    std::string out, err;
};

/// `command` is passed to the shell with the folder as the working directory; "rayscope" in it is the
/// program.
inline ProgramResult run(const TemporaryFolder& folder, std::string command) {
    const std::string program = "rayscope";
    if (command.starts_with(program))
        command.replace(0, program.size(), std::string("'") + RAYSCOPE_PROGRAM + "'");
    const std::string line = "cd '" + folder.path().string() + "' && { " + command + "; } >.out 2>.err";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), readText(folder / ".out"),
            readText(folder / ".err")};
}

}  // namespace rayscope::test
