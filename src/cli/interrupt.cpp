#include "cli/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

#include "base/temporary_files.h"
#include "cli/commands.h"

namespace rayscope::cli {

namespace {

std::atomic<int> guards{0}, interruptCount{0};
static_assert(std::atomic<int>::is_always_lock_free);

void onInterrupt(int signal) {
    const bool isFirst = interruptCount.fetch_add(1) == 0;
    if (guards > 0 && isFirst) return;
    if (guards > 0) endInterrupted();
    base::removeTemporaryFiles();
    // The default action ends the program with the status of the signal.
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

}  // namespace

void installInterruptHandlers() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action {};
        if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
        action = {};
        action.sa_handler = onInterrupt;
        action.sa_flags = SA_RESTART;
        sigaction(signal, &action, nullptr);
    }
}

InterruptGuard::InterruptGuard() {
    if (guards.fetch_add(1) == 0) interruptCount = 0;
}

InterruptGuard::~InterruptGuard() { --guards; }

bool InterruptGuard::interrupted() const { return interruptCount > 0; }

void endInterrupted() noexcept {
    base::removeTemporaryFiles();
    _exit(kInterrupted);
}

}  // namespace rayscope::cli
