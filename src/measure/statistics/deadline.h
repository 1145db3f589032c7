#pragma once
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace rayscope::measure {

/// Requests a stop after some seconds, or when one is requested through `outer`.
class Deadline {
  public:
    Deadline(double seconds, const std::stop_token& outer)
        : forward_(outer, [this] { source_.request_stop(); }),
          timer_([this, seconds](const std::stop_token& destroyed) {
              std::unique_lock guard(lock_);
              const std::chrono::duration<double> limit(std::min(seconds, 1e8));
              wake_.wait_for(guard, destroyed, limit, [] { return false; });
              if (!destroyed.stop_requested()) source_.request_stop();
          }) {}
    std::stop_token token() const { return source_.get_token(); }

  private:
    std::stop_source source_;
    std::stop_callback<std::function<void()>> forward_;
    std::mutex lock_;
    std::condition_variable_any wake_;
    std::jthread timer_;
};

}  // namespace rayscope::measure
