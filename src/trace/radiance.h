#pragma once
#include <rayscope/path.h>
#include <cstdint>
#include <stop_token>

#include "trace/path_observer.h"
#include "trace/world.h"

namespace rayscope::trace {

struct SampleResult {
    RgbSum radiance{0.0};
    std::uint64_t rays = 0;  ///< traced for the sample, of all kinds
};

/// The radiance of a sample: a pure function of world, seed and sample, whatever the observer. Instantiated
/// for NullObserver in radiance.cpp; for other observers include trace/radiance_definition.h. A single sample
/// may take long: if a stop is requested during it, it ends within milliseconds, and the result is
/// meaningless.
template <PathObserver O>
SampleResult radiance(const World& world, std::uint64_t seed, const SampleId& sample, O& observer,
                      const std::stop_token& stop = {});

extern template SampleResult radiance(const World&, std::uint64_t, const SampleId&, NullObserver&,
                                      const std::stop_token&);

}  // namespace rayscope::trace
