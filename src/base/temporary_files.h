#pragma once
// The names of temporary files, so that a signal handler can delete them.
#include <string>

namespace rayscope::base {

/// Remembers a file for removeTemporaryFiles() during its lifetime. It does not delete it.
class TemporaryName {
  public:
    explicit TemporaryName(const std::string& path);
    ~TemporaryName();
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;

  private:
    int slot_;  ///< -1: the table is full, or the path too long
};

/// Deletes the remembered files. Async-signal-safe: for handlers that end the program.
void removeTemporaryFiles() noexcept;

}  // namespace rayscope::base
