#pragma once
// Build times and ray throughput of BVHs, compared with Embree where it is installed.
#include <rayscope/accel.h>
#include <rayscope/interval.h>
#include <rayscope/scene.h>
#include <functional>
#include <string>
#include <vector>

#include "measure/bench/bench_rays.h"

namespace rayscope::measure {

struct BenchOptions {
    BuildSettings build;
    int threads = 1;
    int size = 1024;  ///< of the image of primary rays
    int rounds = 7;   ///< of interleaved measurements
};

/// Throughput for one kind of ray. Ratios are speeds relative to another method in the same round.
struct RayTiming {
    BenchRayKind kind;
    std::size_t rays = 0, hits = 0;
    double single = 0.0, batched = 0.0;  ///< million rays per second, medians
    double embreeSingle = 0.0, embreeRobust = 0.0, embreePacket16 = 0.0,
           embreeStream = 0.0;                ///< 0: not measured
    Interval singleToSingle, singleToRobust;  ///< single rays to Embree's, default and robust mode
    Interval batchedToSingle;                 ///< batched queries to Embree's single rays
    Interval batchedToBest;       ///< batched queries to the fastest of Embree's queries in each round
    Interval batchedToOwnSingle;  ///< batched queries to single rays
    double nodes = 0.0, leaves = 0.0, primitives = 0.0, exact = 0.0;  ///< per ray, see TraversalCounts
    std::size_t mismatches = 0;  ///< rays that hit here and miss in Embree's robust mode, or the reverse
};

struct BenchRow {
    std::string scene;
    std::size_t triangles = 0, spheres = 0;
    int threads = 1;
    BuildSettings build;
    Isa isa = Isa::Auto;                                    ///< of the kernels; Auto: no kernels
    Interval buildSeconds, embreeBuildSeconds, buildRatio;  ///< ratio: Embree's time over Rayscope's
    double sahCost = 0.0, countedCost = 0.0;                ///< SAH cost; cost of random lines
    AccelSummary summary;
    double blockFill = 0.0;  ///< triangles per leaf of the wide layout
    double bytesPerPrimitive = 0.0, embreeBytesPerPrimitive = 0.0;
    std::vector<RayTiming> rays;
};

/// Calls `progress` with the name of each measurement.
BenchRow runBench(const std::string& name, const AccelInput& input, const CameraDescription& camera,
                  const glm::vec3& light, const BenchOptions& options,
                  const std::function<void(const std::string&)>& progress);

}  // namespace rayscope::measure
