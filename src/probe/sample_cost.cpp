#include "probe/sample_cost.h"

#include <algorithm>
#include <chrono>

#include "math/vectors.h"
#include "probe/counting_observer.h"
#include "sampling/sample_stream.h"
#include "trace/radiance_definition.h"

namespace rayscope::probe {

SampleCost costAt(const trace::World& world, std::uint64_t seed, int x, int y, int samples,
                  bool countTraversals, const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    SampleCost cost;
    const Clock::time_point start = Clock::now();
    trace::NullObserver silent;
    for (int index = 0; index < samples && !stop.stop_requested(); ++index) {
        const trace::SampleResult result = trace::radiance(world, seed, {x, y, index}, silent, stop);
        cost.rays += static_cast<double>(result.rays);
        cost.nonFinite += math::isFinite(result.radiance) ? 0 : 1;
    }
    cost.microseconds = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
    for (int index = 0; countTraversals && index < samples && !stop.stop_requested(); ++index) {
        const sampling::SampleStream stream(world.settings.sampler, seed, x, y, index, world.settings.spp);
        CountingObserver observer(world, world.moves ? stream.get1D(sampling::Dim::Time) : 0.0f);
        trace::radiance(world, seed, {x, y, index}, observer, stop);
        cost.nodes += static_cast<double>(observer.counts().nodes + observer.counts().leaves);
        cost.tests += static_cast<double>(observer.counts().primitives);
    }
    const double n = std::max(samples, 1);
    return {cost.nodes / n, cost.tests / n, cost.rays / n, cost.microseconds / n, cost.nonFinite};
}

}  // namespace rayscope::probe
