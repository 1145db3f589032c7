#pragma once
#include <rayscope/diagnostics.h>
#include <cstddef>
#include <stop_token>

namespace rayscope::bvh {

/// Loops over nodes or primitives check for a stop once per this number of iterations.
constexpr std::size_t kStopInterval = 16384;

inline void throwIfStopped(const std::stop_token& stop) {
    if (stop.stop_requested()) throw Stopped{};
}

}  // namespace rayscope::bvh
