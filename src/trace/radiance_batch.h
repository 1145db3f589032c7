#pragma once
#include <span>
#include <vector>

#include "sampling/sample_stream.h"
#include "trace/camera_sample.h"
#include "trace/term_queue.h"

namespace rayscope::trace {

/// Computes the radiance of many samples, bit for bit as radiance() does, in less time: camera rays and
/// shadow rays are traced in batches.
///
/// Usage: start(), then trace() for each sample in order, then finish().
class RadianceBatch {
  public:
    static constexpr std::size_t kSize = 256;  ///< samples for which a batch is efficient

    RadianceBatch(const World& world, std::uint64_t seed);

    void start(std::span<const SampleId> samples);
    void trace(std::size_t sample);
    /// Valid until the next start().
    std::span<const SampleResult> finish();

  private:
    const World& world_;
    std::uint64_t seed_;
    bool hasSingleRays_;  ///< hasSingleCameraRays(), and the world does not move
    std::vector<sampling::SampleStream> streams_;
    std::vector<CameraSample> cameraSamples_;
    std::vector<Ray> rays_;
    std::vector<Hit> hits_;
    std::vector<SampleResult> results_;
    TermQueue queue_;
};

}  // namespace rayscope::trace
