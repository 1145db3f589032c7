#pragma once
#include <span>
#include <stop_token>
#include <vector>

#include "sampling/sample_stream.h"
#include "trace/camera_sample.h"
#include "trace/term_queue.h"

namespace rayscope::trace {

/// Computes the radiance of many samples, bit for bit as radiance() does, in less time: camera rays and
/// shadow rays are traced in batches.
///
/// Usage: start(), then trace() for each sample in order, then finish(). After a stop request the results are
/// meaningless.
class RadianceBatch {
  public:
    static constexpr std::size_t kSize = 256;  ///< samples for which a batch is efficient

    /// The token must outlive the batch.
    RadianceBatch(const World& world, std::uint64_t seed, const std::stop_token& stop);

    /// The number of samples that start() should get: kSize, or 1 where rays are so slow that a stop would
    /// have to wait for the rays of a batch.
    std::size_t size() const { return world_.hasSlowRays ? 1 : kSize; }

    void start(std::span<const SampleId> samples);
    void trace(std::size_t sample);
    /// Valid until the next start().
    std::span<const SampleResult> finish();

  private:
    const World& world_;
    std::uint64_t seed_;
    const std::stop_token& stop_;
    bool hasSingleRays_;  ///< hasSingleCameraRays(), and the world does not move
    std::vector<sampling::SampleStream> streams_;
    std::vector<CameraSample> cameraSamples_;
    std::vector<Ray> rays_;
    std::vector<Hit> hits_;
    std::vector<SampleResult> results_;
    TermQueue queue_;
};

}  // namespace rayscope::trace
