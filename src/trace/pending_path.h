#pragma once
#include <cstdint>

#include "sampling/sample_stream.h"
#include "trace/path_observer.h"

namespace rayscope::trace {

/// A vertex of the path tree.
struct PathBranch {
    sampling::PathKey key{};
    /// An earlier vertex split into several rays: every choice takes one sample from here on.
    bool split = false;
    /// The rest of the sample lies behind this vertex: no later part of the sample has terms to add.
    bool isLast = false;
};

/// A path up to a ray that has not been traced yet.
struct PendingPath {
    Segment segment;  ///< with that ray
    PathBranch branch;
    std::uint32_t layer = 0;   ///< number of transparent surfaces crossed since the latest reflection
    std::uint32_t sample = 0;  ///< number of the sample within its batch
};

}  // namespace rayscope::trace
