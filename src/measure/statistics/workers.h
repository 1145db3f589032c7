#pragma once
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace rayscope::measure {

/// The task arena of a measurement; 0 threads: one per core.
class Workers {
  public:
    explicit Workers(int threads = 0)
        : count_(threads > 0 ? threads : oneapi::tbb::info::default_concurrency()),
          parallelism_(oneapi::tbb::global_control::max_allowed_parallelism,
                       static_cast<std::size_t>(std::max(count_, oneapi::tbb::info::default_concurrency()))),
          arena_(count_) {}

    int count() const { return count_; }
    template <class Work>
    auto run(Work&& work) {
        return arena_.execute(std::forward<Work>(work));
    }

  private:
    int count_;
    oneapi::tbb::global_control parallelism_;
    oneapi::tbb::task_arena arena_;
};

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
