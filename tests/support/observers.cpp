#include "support/tracing.h"
#include "trace/radiance.inl"

namespace rayscope::trace {

template SampleResult radiance(const World&, std::uint64_t, const SampleName&, test::CountingObserver&);
template SampleResult radiance(const World&, std::uint64_t, const SampleName&, test::RecordingObserver&);

}  // namespace rayscope::trace
