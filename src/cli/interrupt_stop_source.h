#pragma once
#include <atomic>
#include <stop_token>
#include <string>
#include <thread>

#include "cli/interrupt.h"

namespace rayscope::cli {

/// Requests a stop at the first interrupt, at most 20 ms later. A second one ends the program. So does the
/// first after half a second, as long as there is no result to keep: opening a pipe and decoding an image
/// cannot be stopped.
class InterruptStopSource {
  public:
    InterruptStopSource();
    std::stop_token token() const { return stop_.get_token(); }
    bool interrupted() const { return interrupt_.interrupted(); }

    /// From now on there is a result to keep: an interrupt only requests a stop. If the work has not ended a
    /// second later, `notice` is printed; it says what still happens.
    void keepResult(std::string notice);

  private:
    void watch(const std::stop_token& ended);

    InterruptGuard interrupt_;
    std::stop_source stop_;
    std::string notice_;
    std::atomic<bool> keepsResult_{false};
    std::jthread watcher_;  ///< last member: joined before the others are destroyed
};

}  // namespace rayscope::cli
