#pragma once
#include <rayscope/interval.h>
#include <cstdint>

#include "trace/compile.h"

namespace rayscope::measure {

/// How fast a whole picture is, and how much of its time is search.
struct PictureTiming {
    int size = 0;     ///< width and height
    int samples = 0;  ///< per pixel
    std::uint64_t rays = 0;
    double picture = 0.0;  ///< million rays per second of the whole picture, median
    double queries = 0.0;  ///< of batched queries with the same rays, median
    Interval share;        ///< time of the queries over that of the picture, in the same round
};

/// Renders the scene of the request, which need not have a size, at a width and height of at most `size`,
/// fewer if the picture had more rays than about four million; and traces the same rays by batched queries.
PictureTiming timePicture(trace::CompileRequest request, int size, int threads, int rounds);

}  // namespace rayscope::measure
