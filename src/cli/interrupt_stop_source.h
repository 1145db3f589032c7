#pragma once
#include <chrono>
#include <stop_token>
#include <thread>

#include "cli/interrupt.h"

namespace rayscope::cli {

/// Asks for a stop as soon as the user does; a measurement looks at it between samples.
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

  private:
    InterruptGuard interrupt_;
    std::stop_source stop_;
    std::jthread watcher_;
};

}  // namespace rayscope::cli
