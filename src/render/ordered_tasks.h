#pragma once
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>

#include <atomic>

namespace rayscope::render {

/// Calls work(i) for 0 <= i < count on the threads of the arena. The threads take the numbers in order from
/// one counter, for locality and an even load.
template <class Work>
void runOrderedTasks(int count, const Work& work) {
    // The two counters also give the thread sanitizer, which cannot see the synchronisation within TBB, the
    // order of set-up, tasks and return.
    std::atomic<int> next, completed;
    next.store(0);
    completed.store(0);
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<int>(0, count, 1),
        [&](const oneapi::tbb::blocked_range<int>& range) {
            for (int i = range.begin(); i != range.end(); ++i) {
                work(next.fetch_add(1));
                completed.fetch_add(1);
            }
        },
        oneapi::tbb::simple_partitioner{});
    completed.load();
}

}  // namespace rayscope::render
