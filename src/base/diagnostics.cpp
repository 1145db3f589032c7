#include <fmt/format.h>
#include <rayscope/diagnostics.h>

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
    const SourcePosition& at = diagnostic.position;
    std::string position;
    if (!at.file.empty()) position = at.file + ":";
    if (at.line > 0) position += fmt::format("{}:", at.line);
    if (at.line > 0 && at.column > 0) position += fmt::format("{}:", at.column);
    if (!position.empty()) position += " ";
    return fmt::format("{}{}: {}", position, nameOf(diagnostic.severity), diagnostic.message);
}

InputError::InputError(std::string message, SourcePosition position)
    : std::runtime_error(toString({Severity::Error, message, position})),
      diagnostic_{Severity::Error, std::move(message), std::move(position)} {}

}  // namespace rayscope
