#include "trace/radiance_batch.h"

#include "trace/radiance.inl"

namespace rayscope::trace {

RadianceBatch::RadianceBatch(const World& world, std::uint64_t seed)
    : world_(world), seed_(seed), hasSingleRays_(!world.moves && hasSingleCameraRays(world)), queue_(world) {
    streams_.reserve(kSize);
    samples_.reserve(kSize);
    rays_.reserve(kSize);
}

void RadianceBatch::start(std::span<const SampleId> names) {
    streams_.clear();
    samples_.clear();
    // One step at a time for all samples: steps of different samples do not wait for one another.
    const Settings& settings = world_.settings;
    for (const SampleId& name : names)
        streams_.emplace_back(settings.sampler, seed_, name.x, name.y, name.index, settings.spp);
    for (std::size_t i = 0; i < names.size(); ++i) samples_.emplace_back(world_, streams_[i], names[i]);
    rays_.resize(hasSingleRays_ ? names.size() : 0);
    for (std::size_t i = 0; i < rays_.size(); ++i)
        rays_[i] = singleCameraRay(world_, streams_[i], samples_[i]);
    hits_.resize(rays_.size());
    world_.closestHits(rays_, 0.0f, hits_);
    results_.assign(names.size(), SampleResult{});
    queue_.start(results_);
}

void RadianceBatch::trace(std::size_t i) {
    NullObserver silent;
    queue_.beginSample(i);
    Tracer<NullObserver, TermQueue> tracer(world_, streams_[i], samples_[i], silent, queue_);
    results_[i].rays = hasSingleRays_ ? tracer.traceSample(rays_[i], hits_[i]) : tracer.traceSample();
}

std::span<const SampleResult> RadianceBatch::finish() {
    queue_.fold();
    return results_;
}

}  // namespace rayscope::trace
