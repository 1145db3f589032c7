// The program. Errors of every kind end here or in runCommandLine(), as one line on stderr and an exit code.
#include <csignal>

#include "base/console.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/interrupt.h"
#include "render/crash_report.h"
#include "render/prepare_threads.h"

int main(int argc, char** argv) {
    using namespace rayscope;
    base::openStandardStreams();
    // A limit on the size of files should fail a write, as a full disk does, not end the program.
    std::signal(SIGXFSZ, SIG_IGN);
    render::installCrashReport();
    cli::installTerminateHandler();
    render::prepareThreads();
    cli::installInterruptHandlers();
    int code = cli::kInputError;
    try {
        code = cli::runCommandLine(cli::commandTable(), {argv + 1, argv + argc});
    } catch (...) {
        code = cli::reportFailure();
    }
    const bool isWritten = base::finishOutput();
    return code == cli::kSuccess && !isWritten ? static_cast<int>(cli::kInputError) : code;
}
