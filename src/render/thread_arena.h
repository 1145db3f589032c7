#pragma once
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>
#include <rayscope/render_session.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/check_argument.h"

namespace rayscope::render {

/// The TBB threads of a computation, the calling thread included. There may be more of them than cores.
class ThreadArena {
  public:
    /// 0 takes one thread per core. Throws std::invalid_argument unless 0 <= threads <= kMaxThreads.
    explicit ThreadArena(int threads = 0)
        : count_(countFor(threads)),
          parallelism_(oneapi::tbb::global_control::max_allowed_parallelism,
                       static_cast<std::size_t>(std::max(count_, oneapi::tbb::info::default_concurrency()))),
          arena_(count_) {}

    int count() const { return count_; }
    /// The count() of an arena with this argument; throws like the constructor.
    static int countFor(int threads) {
        base::checkArgument(threads >= 0 && threads <= kMaxThreads, "threads is {}; expected 0 … {}", threads,
                            kMaxThreads);
        return threads > 0 ? threads : oneapi::tbb::info::default_concurrency();
    }

    /// Runs `work` within the arena: parallel algorithms in it use these threads.
    template <class Work>
    auto run(Work&& work) {
        return arena_.execute(std::forward<Work>(work));
    }

  private:
    int count_;
    // TBB's default limit is one thread per core.
    oneapi::tbb::global_control parallelism_;
    oneapi::tbb::task_arena arena_;
};

}  // namespace rayscope::render
