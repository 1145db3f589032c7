#include "support/tracing.h"
#include "trace/radiance_definition.h"

namespace rayscope::trace {

template SampleResult radiance(const World&, std::uint64_t, const SampleId&, test::EventCounter&,
                               const std::stop_token&);
template SampleResult radiance(const World&, std::uint64_t, const SampleId&, test::RecordingObserver&,
                               const std::stop_token&);

}  // namespace rayscope::trace
