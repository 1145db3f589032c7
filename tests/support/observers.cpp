#include "support/tracing.h"
#include "trace/radiance_definition.h"

namespace rayscope::trace {

template SampleResult radiance(const World&, std::uint64_t, const SampleId&, test::EventCounter&);
template SampleResult radiance(const World&, std::uint64_t, const SampleId&, test::RecordingObserver&);

}  // namespace rayscope::trace
