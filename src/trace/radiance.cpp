#include "trace/radiance.inl"

namespace rayscope::trace {

template SampleResult radiance(const World&, std::uint64_t, const SampleName&, NullObserver&);

}  // namespace rayscope::trace
