#pragma once
#include <rayscope/path.h>
#include <cstdint>

#include "trace/path_observer.h"
#include "trace/world.h"

namespace rayscope::trace {

struct SampleResult {
    RgbSum radiance{0.0};
    std::uint64_t rays = 0;  ///< traced for the sample, of all kinds
};

/// The radiance of a sample: a pure function of world, seed and sample, whatever the observer. Instantiated
/// for NullObserver in radiance.cpp; for other observers include trace/radiance_definition.h.
template <PathObserver O>
SampleResult radiance(const World& world, std::uint64_t seed, const SampleId& sample, O& observer);

extern template SampleResult radiance(const World&, std::uint64_t, const SampleId&, NullObserver&);

}  // namespace rayscope::trace
