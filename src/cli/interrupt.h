#pragma once

namespace rayscope::cli {

/// To be called once at the start of the program. From then on SIGINT (Ctrl+C), SIGTERM and SIGHUP delete
/// temporary files before they end the program. Signals that are ignored at the start, as in background jobs
/// and under nohup, stay ignored.
void installInterruptHandlers();

/// During its lifetime the first of these signals sets a flag and the second ends the program with exit code
/// 130. Several may exist, one within the lifetime of another; they share the flag.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    bool interrupted() const;
};

/// Ends the program with exit code 130, without temporary files.
[[noreturn]] void endInterrupted() noexcept;

}  // namespace rayscope::cli
