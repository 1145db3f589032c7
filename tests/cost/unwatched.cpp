#include "cost/unwatched.h"

#include "radiance_unwatched.inl"

namespace rayscope::trace {

template SampleResult radiance(const World&, std::uint64_t, const SampleName&, Nobody&);

}  // namespace rayscope::trace
