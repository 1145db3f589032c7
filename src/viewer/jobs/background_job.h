#pragma once
#include <rayscope/diagnostics.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <system_error>
#include <utility>

#include "base/memory_budget.h"
#include "viewer/jobs/thread_priority.h"

namespace rayscope::viewer {

/// 0 … 1; written by the thread of a job and read by the window's.
using JobProgress = std::atomic<double>;

/// A computation on a thread of its own with a lower priority, so that the window stays responsive. All
/// members are called from the window's thread and none of them blocks; only the destructor waits for the
/// computation to stop. If the system starts no more threads, poll() runs the work instead.
template <class Result>
class BackgroundJob {
  public:
    /// Runs on the other thread and must own all that it uses. When a stop is requested it should return
    /// early or throw Stopped.
    using Work = std::function<Result(const std::stop_token&, JobProgress&)>;

    BackgroundJob() = default;
    ~BackgroundJob() { stop_.request_stop(); }
    BackgroundJob(const BackgroundJob&) = delete;
    BackgroundJob& operator=(const BackgroundJob&) = delete;

    /// Starts the work, or stops what runs, drops its result and starts the work after it.
    void start(Work work) {
        if (running_.valid()) {
            discard();
            next_ = std::move(work);
        } else {
            launch(std::move(work));
        }
    }

    /// The result, once, as soon as there is one. If the work threw there is none: after Stopped nothing is
    /// reported, other exceptions leave their text in error().
    std::optional<Result> poll() {
        // A deferred computation is not ready before it is asked for.
        if (!running_.valid() || running_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout)
            return std::nullopt;
        std::optional<Result> result;
        try {
            result = running_.get();
        } catch (const Stopped&) {
        } catch (const std::bad_alloc& error) {
            if (!discarded_) error_ = std::string("error: ") + base::messageOf(error);
        } catch (const std::exception& error) {
            if (!discarded_) error_ = error.what();
        }
        if (std::exchange(discarded_, false)) result.reset();
        if (next_) launch(*std::exchange(next_, std::nullopt));
        return result;
    }

    /// Requests a stop; the result that the work then returns is still delivered.
    void cancel() {
        stop_.request_stop();
        next_.reset();
    }
    /// Requests a stop; no result is delivered.
    void discard() {
        cancel();
        discarded_ = running_.valid();
    }

    bool busy() const { return running_.valid(); }
    double progress() const { return running_.valid() ? progress_->load() : 0.0; }
    /// Why the latest work failed; empty if it did not.
    const std::string& error() const { return error_; }

  private:
    void launch(Work work) {
        stop_ = std::stop_source{};
        progress_ = std::make_shared<JobProgress>(0.0);
        error_.clear();
        const auto shared = std::make_shared<Work>(std::move(work));
        const auto run = [shared, stop = stop_.get_token(), progress = progress_] {
            // What the work owns is destroyed here, not on the window's thread.
            const Work once = std::move(*shared);
            return once(stop, *progress);
        };
        try {
            running_ = std::async(std::launch::async, [run] {
                lowerThreadPriority();
                return run();
            });
        } catch (const std::system_error&) {
            running_ = std::async(std::launch::deferred, run);
        }
    }

    std::future<Result> running_;
    std::optional<Work> next_;
    std::stop_source stop_;
    std::shared_ptr<JobProgress> progress_;
    std::string error_;
    bool discarded_ = false;  ///< the result of what runs is not wanted
};

}  // namespace rayscope::viewer
