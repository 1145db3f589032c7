#pragma once
#include <chrono>
#include <stop_token>
#include <thread>

#include "cli/interrupt.h"

namespace rayscope::cli {

/// Requests a stop at the first Ctrl+C, at most 20 ms later. A second Ctrl+C ends the program.
class InterruptStopSource {
  public:
    InterruptStopSource()
        : watcher_([this](const std::stop_token& ended) {
              while (!ended.stop_requested()) {
                  if (interrupt_.interrupted()) stop_.request_stop();
                  std::this_thread::sleep_for(std::chrono::milliseconds(20));
              }
          }) {}
    std::stop_token token() const { return stop_.get_token(); }
    bool interrupted() const { return interrupt_.interrupted(); }

  private:
    InterruptGuard interrupt_;
    std::stop_source stop_;
    std::jthread watcher_;
};

}  // namespace rayscope::cli
