#include "cli/failure.h"

#include <rayscope/diagnostics.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

#include "base/console.h"
#include "base/memory_budget.h"
#include "base/temporary_files.h"
#include "cli/commands.h"

namespace rayscope::cli {

namespace {

void printError(std::string_view text) noexcept {
    base::writeMessage("error: ");
    try {
        base::writeMessage(base::shortened(base::printable(text), 490));
    } catch (...) {  // no memory even for that
        base::writeMessage("out of memory");
    }
    base::writeMessage("\n");
}

// No allocation: there may be no memory left.
void printOutOfMemory(const std::bad_alloc& error) noexcept {
    base::writeMessage("error: ");
    base::writeMessage(base::messageOf(error));
    base::writeMessage("\n");
}

/// oneTBB reports a thread that cannot be created as a runtime_error with the name of the function.
bool isAboutThreads(const std::exception& error) noexcept {
    if (const auto* const system = dynamic_cast<const std::system_error*>(&error))
        return system->code() == std::errc::resource_unavailable_try_again;
    return std::strstr(error.what(), "pthread_create") != nullptr;
}

[[noreturn]] void onTerminate() {
    if (!std::current_exception()) std::abort();
    int code = kInputError;
    try {
        throw;
    } catch (...) {
        code = reportFailure();
    }
    base::removeTemporaryFiles();
    _exit(code);
}

}  // namespace

const char* messageOf(const std::exception& error) noexcept {
    return isAboutThreads(error) ? "the system does not start more threads or has no memory for them; try "
                                   "fewer with --threads"
                                 : error.what();
}

int reportFailure() noexcept {
    try {
        throw;
    } catch (const InputError& error) {
        base::writeMessage(error.what());
        base::writeMessage("\n");
    } catch (const std::bad_alloc& error) {
        printOutOfMemory(error);
    } catch (const std::length_error&) {  // of a vector that no memory could hold
        printOutOfMemory({});
    } catch (const Stopped&) {
        return kInterrupted;
    } catch (const std::exception& error) {
        printError(messageOf(error));
    } catch (...) {
        printError("unknown exception");
    }
    return kInputError;
}

void installTerminateHandler() { std::set_terminate(onTerminate); }

}  // namespace rayscope::cli
