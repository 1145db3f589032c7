#pragma once
// How fast a scene's hierarchy is built and searched, beside Embree where it is installed.
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
    int rounds = 7;   ///< all contestants take turns in each
};

/// One contestant's speed, and its own in units of a rival's in the same round.
struct RayTiming {
    BenchRayKind kind;
    std::size_t rays = 0, hits = 0;
    double single = 0.0, batched = 0.0;  ///< million rays per second, medians
    double embreeSingle = 0.0, embreeRobust = 0.0, embreePacket16 = 0.0,
           embreeStream = 0.0;                ///< 0: not measured
    Interval singleToSingle, singleToRobust;  ///< own single rays against Embree's
    Interval batchedToSingle;                 ///< own batched queries against Embree's single rays
    Interval batchedToBest;  ///< the same against the fastest of Embree's queries in each round
    Interval batchedToOwnSingle;
    double nodes = 0.0, leaves = 0.0, primitives = 0.0, exact = 0.0;  ///< per ray, see TraversalCounts
    std::size_t mismatches = 0;  ///< rays whose hit or miss differs from Embree's robust mode
};

struct BenchRow {
    std::string scene;
    std::size_t triangles = 0, spheres = 0;
    int threads = 1;
    BuildSettings build;
    Isa isa = Isa::Auto;                                    ///< of the kernels; Auto: none
    Interval buildSeconds, embreeBuildSeconds, buildRatio;  ///< ratio: Embree's time over the own
    double sahCost = 0.0, countedCost = 0.0;                ///< as predicted, and of random lines
    AccelSummary summary;
    double blockFill = 0.0;  ///< triangles per leaf of the wide layout
    double bytesPerPrimitive = 0.0, embreeBytesPerPrimitive = 0.0;
    std::vector<RayTiming> rays;
};

/// `note` is told what is being measured. Throws Stopped on request.
BenchRow runBench(const std::string& name, const AccelInput& input, const CameraDescription& camera,
                  const glm::vec3& light, const BenchOptions& options,
                  const std::function<void(const std::string&)>& note);

}  // namespace rayscope::measure
