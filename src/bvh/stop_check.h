#pragma once
#include <rayscope/diagnostics.h>
#include <stop_token>

namespace rayscope::bvh {

inline void throwIfStopped(const std::stop_token& stop) {
    if (stop.stop_requested()) throw Stopped{};
}

}  // namespace rayscope::bvh
