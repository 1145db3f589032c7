#pragma once
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "sampling/sample_stream.h"
#include "trace/camera_sample.h"
#include "trace/term_queue.h"

namespace rayscope::trace {

/// Computes the radiance of many samples, bit for bit as radiance() does, in less time: in waves. The first
/// wave traces the camera rays of all samples as a batch; each further one traces the rays with which the
/// paths of the wave before it continue. Shadow rays are traced in batches, too.
///
/// A path whose sample has other parts to trace after it, such as one of several glossy rays, is followed to
/// its end at once, so that the terms of a sample are added in the order of its paths.
///
/// Usage: start(), then trace() as long as next() returns a sample, then finish(). After a stop request the
/// results are meaningless.
class RadianceBatch {
  public:
    static constexpr std::size_t kSize = 256;  ///< samples for which a batch is efficient

    /// The token must outlive the batch.
    RadianceBatch(const World& world, std::uint64_t seed, const std::stop_token& stop);

    /// The number of samples that start() should get: kSize, or 1 where rays are so slow that a stop would
    /// have to wait for the rays of a batch.
    std::size_t size() const { return world_.hasSlowRays ? 1 : kSize; }

    void start(std::span<const SampleId> samples);
    /// Advances to the next path of the wave, or of the next wave. Returns the number of its sample; nothing
    /// if all paths have ended.
    std::optional<std::size_t> next();
    /// Follows that path to its end or to a ray of the next wave.
    void trace();
    /// Valid until the next start().
    std::span<const SampleResult> finish();

  private:
    void traceRays();

    const World& world_;
    std::uint64_t seed_;
    const std::stop_token& stop_;
    bool hasSingleRays_;  ///< hasSingleCameraRays(), and the world does not move
    std::vector<sampling::SampleStream> streams_;
    std::vector<glm::vec2> inPixel_;
    std::vector<CameraSample> cameraSamples_;
    std::vector<PendingPath> paths_;  ///< of the current wave, if it is not the first; used up by trace()
    std::vector<Ray> rays_;           ///< of the current wave
    std::vector<Hit> hits_;           ///< of rays_
    std::vector<SampleResult> results_;
    TermQueue queue_;
    bool isFirstWave_ = true;
    std::size_t waveSize_ = 0, next_ = 0, current_ = 0;  ///< paths of the current wave
};

}  // namespace rayscope::trace
