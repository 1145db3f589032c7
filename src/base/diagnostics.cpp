#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include "base/printable_text.h"

namespace rayscope {

namespace {
const char* nameOf(Severity severity) {
    switch (severity) {
        case Severity::Note:
            return "note";
        case Severity::Warning:
            return "warning";
        case Severity::Error:
            break;
    }
    return "error";
}
}  // namespace

std::string toString(const Diagnostic& diagnostic) {
    // Names and values of files are part of the message: they must not act on a terminal, forge another line,
    // or fill the screen.
    constexpr std::size_t kLongestFile = 250, kLongestLine = 500;
    const SourcePosition& at = diagnostic.position;
    std::string position;
    if (!at.file.empty()) position = base::shortened(base::printable(at.file), kLongestFile) + ":";
    if (at.line > 0) position += fmt::format("{}:", at.line);
    if (at.line > 0 && at.column > 0) position += fmt::format("{}:", at.column);
    if (!position.empty()) position += " ";
    position += fmt::format("{}: ", nameOf(diagnostic.severity));
    // Escapes only lengthen the text: what is cut off anyway need not be escaped.
    const std::string message = base::shortened(diagnostic.message, 2 * kLongestLine);
    return position + base::shortened(base::printable(message), kLongestLine - position.size());
}

InputError::InputError(std::string message, SourcePosition position)
    : std::runtime_error(toString({Severity::Error, message, position})),
      diagnostic_{Severity::Error, std::move(message), std::move(position)} {}

}  // namespace rayscope
