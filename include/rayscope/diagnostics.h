#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace rayscope {

/// A position in a text file. Lines and columns count from 1; 0 means unknown.
struct SourcePosition {
    std::string file;
    int line = 0;
    int column = 0;
};

enum class Severity { Note, Warning, Error };

/// One message about the input, for the user.
struct Diagnostic {
    Severity severity = Severity::Error;
    std::string message;
    SourcePosition position;
};

/// "file:line:column: error: message", without unknown parts of the position.
std::string toString(const Diagnostic& diagnostic);

/// Notes and warnings in the order in which a reader found them.
using Diagnostics = std::vector<Diagnostic>;

/// An invalid scene, setting or file. `what()` is the complete line to show to the user, see toString().
class InputError : public std::runtime_error {
  public:
    explicit InputError(std::string message, SourcePosition position = {});
    const Diagnostic& diagnostic() const { return diagnostic_; }

  private:
    Diagnostic diagnostic_;
};

/// Thrown by long operations (loading, building) after a stop request.
struct Stopped : std::exception {
    const char* what() const noexcept override { return "stopped"; }
};

}  // namespace rayscope
