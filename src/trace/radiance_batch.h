#pragma once
#include <span>
#include <vector>

#include "sampling/sample_stream.h"
#include "trace/camera_sample.h"
#include "trace/term_queue.h"

namespace rayscope::trace {

/// Computes the radiance of many samples: for each bit for bit what radiance() finds, in less time, because
/// the camera rays of all of them are searched together, and so are their shadow rays.
///
/// start(), then trace() for each sample in order, then finish().
class RadianceBatch {
  public:
    static constexpr std::size_t kSize = 256;  ///< samples that are worth a batch

    RadianceBatch(const World& world, std::uint64_t seed);

    void start(std::span<const SampleId> names);
    void trace(std::size_t sample);
    /// Valid until the next start().
    std::span<const SampleResult> finish();

  private:
    const World& world_;
    std::uint64_t seed_;
    bool hasSingleRays_;  ///< of the camera, that depend on nothing else
    std::vector<sampling::SampleStream> streams_;
    std::vector<CameraSample> samples_;
    std::vector<Ray> rays_;
    std::vector<Hit> hits_;
    std::vector<SampleResult> results_;
    TermQueue queue_;
};

}  // namespace rayscope::trace
