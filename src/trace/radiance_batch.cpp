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
    paths_.reserve(size());
    queue_.reservePaths(size());
}

void RadianceBatch::start(std::span<const SampleId> samples) {
    streams_.clear();
    cameraSamples_.clear();
    // Step by step for all samples: steps of different samples are independent, which hides their latency.
    const Settings& settings = world_.settings;
    const SampleId* previous = nullptr;
    for (const SampleId& sample : samples) {
        if (previous && previous->x == sample.x && previous->y == sample.y)
            streams_.push_back(streams_.back().withIndex(sample.index));
        else
            streams_.emplace_back(settings.sampler, seed_, sample.x, sample.y, sample.index, settings.spp);
        previous = &sample;
    }
    inPixel_.resize(samples.size());
    sampling::SampleStream::get2D(sampling::Dim::Pixel, streams_, inPixel_);
    for (std::size_t i = 0; i < samples.size(); ++i)
        cameraSamples_.emplace_back(world_, streams_[i], samples[i], inPixel_[i]);
    rays_.resize(hasSingleRays_ ? samples.size() : 0);
    for (std::size_t i = 0; i < rays_.size(); ++i)
        rays_[i] = singleCameraRay(world_, streams_[i], cameraSamples_[i]);
    traceRays();
    results_.assign(samples.size(), SampleResult{});
    queue_.start(results_);
    isFirstWave_ = true;
    waveSize_ = samples.size();
    next_ = 0;
}

void RadianceBatch::traceRays() {
    hits_.resize(rays_.size());
    world_.closestHits(rays_, 0.0f, hits_);
}

std::optional<std::size_t> RadianceBatch::next() {
    if (next_ == waveSize_) {
        queue_.takePaths(paths_);
        if (paths_.empty()) return {};
        rays_.clear();
        for (const PendingPath& path : paths_) rays_.push_back(path.segment.ray);
        traceRays();
        isFirstWave_ = false;
        waveSize_ = paths_.size();
        next_ = 0;
    }
    current_ = next_++;
    return isFirstWave_ ? current_ : paths_[current_].sample;
}

void RadianceBatch::trace() {
    const std::size_t sample = isFirstWave_ ? current_ : paths_[current_].sample;
    NullObserver observer;
    queue_.beginSample(sample);
    Tracer<NullObserver, TermQueue> tracer(world_, streams_[sample], cameraSamples_[sample], observer, queue_,
                                           stop_);
    std::uint64_t& rays = results_[sample].rays;
    if (!isFirstWave_)
        rays += tracer.tracePath(paths_[current_], hits_[current_]);
    else if (hasSingleRays_)
        rays += tracer.traceSample(rays_[current_], hits_[current_]);
    else
        rays += tracer.traceSample();
}

std::span<const SampleResult> RadianceBatch::finish() {
    queue_.fold();
    return results_;
}

}  // namespace rayscope::trace
