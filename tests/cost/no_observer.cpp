#include "cost/no_observer.h"

#include "radiance_unwatched.inl"

namespace rayscope::trace {

template SampleResult radiance(const World&, std::uint64_t, const SampleId&, NoObserver&);

}  // namespace rayscope::trace
