#include "faults/forked_command.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "base/console.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/failure.h"
#include "render/prepare_threads.h"

namespace rayscope::test {

namespace {

constexpr unsigned kMostSeconds = 300;

/// A file without a name that takes what a child writes.
class MemoryFile {
  public:
    MemoryFile() : descriptor_(::memfd_create("output", 0)) {}
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() { ::close(descriptor_); }
    int descriptor() const { return descriptor_; }
    std::string text() const {
        std::string text(static_cast<std::size_t>(::lseek(descriptor_, 0, SEEK_END)), '\0');
        return ::pread(descriptor_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size()) ? text
                                                                                                      : "";
    }

  private:
    int descriptor_;
};

/// Like main().
int runCommand(const std::vector<std::string>& arguments) {
    int code = cli::kInputError;
    try {
        code = cli::runCommandLine(cli::commandTable(), arguments);
    } catch (...) {
        code = cli::reportFailure();
    }
    return base::finishOutput() ? code : static_cast<int>(cli::kInputError);
}

}  // namespace

CommandOutcome runForked(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                         const Fault& fault) {
    const MemoryFile out, err;
    std::fflush(nullptr);
    // Before the fork, so that the child shares the count.
    FaultPoints::arm(fault.kind, 0, false);
    FaultPoints::disarm();
    const pid_t child = ::fork();
    if (child == 0) {
        ::alarm(kMostSeconds);
        ::dup2(out.descriptor(), STDOUT_FILENO);
        ::dup2(err.descriptor(), STDERR_FILENO);
        if (::chdir(folder.path().c_str()) != 0) ::_exit(99);
        cli::installTerminateHandler();
        render::prepareThreads();
        FaultPoints::arm(fault.kind, fault.point, fault.andAllAfter);
        const int code = runCommand(arguments);
        FaultPoints::disarm();
        ::_exit(code);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), out.text(), err.text(),
            FaultPoints::count()};
}

}  // namespace rayscope::test
