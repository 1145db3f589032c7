#pragma once
// The definition of radiance() and of all members of Tracer, for files that instantiate them.
#include "trace/direct_lighting.h"
#include "trace/radiance.h"
#include "trace/reflection.h"
#include "trace/tracer.h"

namespace rayscope::trace {

template <PathObserver O>
SampleResult radiance(const World& world, std::uint64_t seed, const SampleId& sample, O& observer,
                      const std::stop_token& stop) {
    const sampling::SampleStream stream(world.settings.sampler, seed, sample.x, sample.y, sample.index,
                                        world.settings.spp);
    const CameraSample cameraSample(world, stream, sample);
    TermSum terms;
    const std::uint64_t rays =
        Tracer<O, TermSum>(world, stream, cameraSample, observer, terms, stop).traceSample();
    return {terms.sum, rays};
}

}  // namespace rayscope::trace
