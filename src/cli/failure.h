#pragma once
#include <exception>

namespace rayscope::cli {

/// To be called in a catch block: prints the exception that is being handled as one line and returns the exit
/// code for it.
int reportFailure() noexcept;

/// What to tell the user about an exception that is neither an InputError nor a std::bad_alloc.
const char* messageOf(const std::exception& error) noexcept;

/// Makes an exception that nothing catches, such as those of threads, end the program like the others instead
/// of aborting it.
void installTerminateHandler();

}  // namespace rayscope::cli
