#pragma once
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <system_error>
#include <thread>

namespace rayscope::render {

/// The stop of the tiles of a pass: requested with `stop`, and some time after `drain`, so that tiles in
/// flight are completed unless they take too long. The same holds for the work on the image after them, with
/// another time. If `drain` was requested before, the time begins with the lifetime.
class TileStop {
  public:
    static constexpr std::chrono::milliseconds kGrace{500};

    TileStop(const std::stop_token& stop, const std::stop_token& drain,
             std::chrono::milliseconds grace = kGrace)
        : grace_(grace),
          onStop_(stop, [this] { source_.request_stop(); }),
          onDrain_(drain, [this] { startTimer(); }) {}

    std::stop_token token() const { return source_.get_token(); }

  private:
    void startTimer() {
        try {
            timer_ = std::jthread([this](const std::stop_token& destroyed) {
                std::unique_lock guard(lock_);
                wake_.wait_for(guard, destroyed, grace_, [] { return false; });
                if (!destroyed.stop_requested()) source_.request_stop();
            });
        } catch (const std::system_error&) {  // no more threads: without grace
            source_.request_stop();
        }
    }

    std::chrono::milliseconds grace_;
    std::stop_source source_;
    std::mutex lock_;
    std::condition_variable_any wake_;
    std::jthread timer_;
    std::stop_callback<std::function<void()>> onStop_, onDrain_;  ///< last: destroyed before what they use
};

}  // namespace rayscope::render
