#pragma once
#include <rayscope/path.h>
#include <cstdint>

#include "trace/path_observer.h"
#include "trace/world.h"

namespace rayscope::trace {

/// What one sample is worth.
struct SampleResult {
    RgbSum radiance{0.0};
    std::uint64_t rays = 0;  ///< traced for it, of all kinds
};

/// The radiance of a sample: a pure function of world, seed and name, whoever watches. Instantiated for the
/// silent observer in radiance.cpp; other observers include radiance.inl.
template <PathObserver O>
SampleResult radiance(const World& world, std::uint64_t seed, const SampleId& name, O& observer);

extern template SampleResult radiance(const World&, std::uint64_t, const SampleId&, NullObserver&);

}  // namespace rayscope::trace
