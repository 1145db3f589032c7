#include "trace/radiance_definition.h"

namespace rayscope::trace {

template SampleResult radiance(const World&, std::uint64_t, const SampleId&, NullObserver&,
                               const std::stop_token&);

}  // namespace rayscope::trace
