#pragma once

namespace rayscope::cli {

/// While it lives, the first Ctrl+C is noted and the second ends the program at once with exit code 130.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    bool interrupted() const;
};

}  // namespace rayscope::cli
