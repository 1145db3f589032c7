#include "trace/radiance_batch.h"

#include "trace/radiance_definition.h"

namespace rayscope::trace {

RadianceBatch::RadianceBatch(const World& world, std::uint64_t seed, const std::stop_token& stop)
    : world_(world),
      seed_(seed),
      stop_(stop),
      hasSingleRays_(!world.moves && hasSingleCameraRays(world)),
      queue_(world, stop) {
    streams_.reserve(kSize);
    cameraSamples_.reserve(kSize);
    rays_.reserve(kSize);
}

void RadianceBatch::start(std::span<const SampleId> samples) {
    streams_.clear();
    cameraSamples_.clear();
    // Step by step for all samples: steps of different samples are independent, which hides their latency.
    const Settings& settings = world_.settings;
    for (const SampleId& sample : samples)
        streams_.emplace_back(settings.sampler, seed_, sample.x, sample.y, sample.index, settings.spp);
    for (std::size_t i = 0; i < samples.size(); ++i)
        cameraSamples_.emplace_back(world_, streams_[i], samples[i]);
    rays_.resize(hasSingleRays_ ? samples.size() : 0);
    for (std::size_t i = 0; i < rays_.size(); ++i)
        rays_[i] = singleCameraRay(world_, streams_[i], cameraSamples_[i]);
    hits_.resize(rays_.size());
    world_.closestHits(rays_, 0.0f, hits_);
    results_.assign(samples.size(), SampleResult{});
    queue_.start(results_);
}

void RadianceBatch::trace(std::size_t i) {
    NullObserver observer;
    queue_.beginSample(i);
    Tracer<NullObserver, TermQueue> tracer(world_, streams_[i], cameraSamples_[i], observer, queue_, stop_);
    results_[i].rays = hasSingleRays_ ? tracer.traceSample(rays_[i], hits_[i]) : tracer.traceSample();
}

std::span<const SampleResult> RadianceBatch::finish() {
    queue_.fold();
    return results_;
}

}  // namespace rayscope::trace
