#include "base/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace rayscope::base {

namespace {

/// The first error of the standard output; 0: none.
int outputError = 0;
bool pipesWereIgnored = false;

void writeTo(std::FILE* stream, std::string_view text, int& error) noexcept {
    if (text.empty() || std::fwrite(text.data(), 1, text.size(), stream) == text.size()) return;
    if (error == 0) error = errno;
}

}  // namespace

void openStandardStreams() {
    for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
        if (::fcntl(descriptor, F_GETFD) != -1) continue;
        // In the wrong direction, so that using the stream fails as it would have. The lowest free number is
        // the closed one.
        ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
    pipesWereIgnored = std::signal(SIGPIPE, SIG_IGN) == SIG_IGN;
}

void writeOutput(std::string_view text) noexcept { writeTo(stdout, text, outputError); }

void writeMessage(std::string_view text) noexcept {
    int dropped = 0;
    writeTo(stderr, text, dropped);
    if (std::fflush(stderr) != 0) std::clearerr(stderr);
}

void flushOutput() noexcept {
    if (std::fflush(stdout) != 0 && outputError == 0) outputError = errno;
}

bool finishOutput() noexcept {
    flushOutput();
    if (outputError == 0) return true;
    if (outputError == EPIPE && !pipesWereIgnored) {
        std::signal(SIGPIPE, SIG_DFL);
        std::raise(SIGPIPE);
    }
    writeMessage("error: the standard output cannot be written: ");
    writeMessage(std::strerror(outputError));
    writeMessage("\n");
    return false;
}

}  // namespace rayscope::base
