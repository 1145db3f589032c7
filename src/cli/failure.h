#pragma once

namespace rayscope::cli {

/// To be called in a catch block: prints the exception that is being handled as one line and returns the exit
/// code for it.
int reportFailure() noexcept;

/// Makes an exception that nothing catches, such as those of threads, end the program like the others instead
/// of aborting it.
void installTerminateHandler();

}  // namespace rayscope::cli
