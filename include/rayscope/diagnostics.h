#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace rayscope {

/// A place in a text file. Lines and columns count from 1; 0 means unknown.
struct SourcePosition {
    std::string file;
    int line = 0;
    int column = 0;
};

enum class Severity { Note, Warning, Error };

/// One message to the person who wrote the input.
struct Diagnostic {
    Severity severity = Severity::Error;
    std::string message;
    SourcePosition position;
};

/// "file:line:column: error: message", without the parts of the position that are unknown.
std::string toString(const Diagnostic& diagnostic);

/// What readers collect while they go on: notes and warnings in the order of their discovery.
using Diagnostics = std::vector<Diagnostic>;

/// A scene, a setting or a file is wrong. `what()` is the whole line that a user should see.
class InputError : public std::runtime_error {
  public:
    explicit InputError(std::string message, SourcePosition position = {});
    const Diagnostic& diagnostic() const { return diagnostic_; }

  private:
    Diagnostic diagnostic_;
};

/// Thrown by long work (loading, building) that was asked to stop.
struct Stopped : std::exception {
    const char* what() const noexcept override { return "stopped"; }
};

}  // namespace rayscope
