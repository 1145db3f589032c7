#pragma once

namespace rayscope::cli {

/// During its lifetime the first Ctrl+C sets a flag and the second ends the program with exit code 130.
/// Several may exist, one within the lifetime of another; they share the flag.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    bool interrupted() const;
};

}  // namespace rayscope::cli
