#include "trace/radiance_definition.h"

namespace rayscope::trace {

template SampleResult radiance(const World&, std::uint64_t, const SampleId&, NullObserver&);

}  // namespace rayscope::trace
