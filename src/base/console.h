#pragma once
// The standard streams. Nothing here throws: what cannot be written to standard error is dropped, and a
// failure of the standard output is remembered until finishOutput().
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "base/printable_text.h"

namespace rayscope::base {

/// To be called first in main(): opens descriptors 0 to 2 that were closed, so that no output file gets their
/// numbers; writing to such a stream fails. A reader that closes its pipe no longer ends the program.
void openStandardStreams();

/// Writes to the standard output, unchanged.
void writeOutput(std::string_view text) noexcept;
/// Writes to standard error at once, unchanged.
void writeMessage(std::string_view text) noexcept;

/// Formats and writes to the standard output, with escapes for control characters other than line feed.
template <class... Arguments>
void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    writeOutput(printableLines(fmt::format(format, std::forward<Arguments>(arguments)...)));
}
/// The same for standard error.
template <class... Arguments>
void printMessage(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    writeMessage(printableLines(fmt::format(format, std::forward<Arguments>(arguments)...)));
}

/// Shows what was written so far.
void flushOutput() noexcept;

/// flushOutput() for the last time. Returns false if anything of the standard output was lost, and prints
/// why, unless its reader closed the pipe: then the program ends here as by SIGPIPE, without a message.
bool finishOutput() noexcept;

}  // namespace rayscope::base
