#include "viewer/jobs/thread_priority.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace rayscope::viewer {

void lowerThreadPriority() {
#ifdef __linux__
    // On Linux the nice value belongs to the thread, and that of another process is not touched. A refusal
    // does not matter.
    constexpr int kLower = 10;
    const auto thread = static_cast<id_t>(gettid());
    setpriority(PRIO_PROCESS, thread, getpriority(PRIO_PROCESS, thread) + kLower);
#endif
}

}  // namespace rayscope::viewer
