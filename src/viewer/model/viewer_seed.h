#pragma once
#include <cstdint>

namespace rayscope::viewer {

/// The seed of everything that the window traces: pictures, replays and measurements share their samples.
inline constexpr std::uint64_t kViewerSeed = 0;

}  // namespace rayscope::viewer
