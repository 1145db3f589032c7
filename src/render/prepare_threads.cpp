#include "render/prepare_threads.h"

#include <oneapi/tbb/cache_aligned_allocator.h>

#include <new>

namespace rayscope::render {

void prepareThreads() noexcept {
    try {
        oneapi::tbb::cache_aligned_allocator<char> allocator;
        allocator.deallocate(allocator.allocate(1), 1);
    } catch (const std::bad_alloc&) {  // which the first use of a thread reports
    }
}

}  // namespace rayscope::render
