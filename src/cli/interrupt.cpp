#include "cli/interrupt.h"

#include <unistd.h>

#include <csignal>

#include "cli/commands.h"

namespace rayscope::cli {

namespace {
volatile std::sig_atomic_t interruptCount = 0;
int guards = 0;

void onInterrupt(int) {
    interruptCount = interruptCount + 1;
    if (interruptCount > 1) _exit(kInterrupted);
}
}  // namespace

InterruptGuard::InterruptGuard() {
    if (guards++ > 0) return;
    interruptCount = 0;
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
}

InterruptGuard::~InterruptGuard() {
    if (--guards > 0) return;
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool InterruptGuard::interrupted() const { return interruptCount > 0; }

}  // namespace rayscope::cli
