#pragma once
#include "trace/radiance.h"

namespace rayscope::trace {

/// radiance() for this observer comes from a tracer from whose source every call of the observer was deleted.
struct NoObserver : NullObserver {};

extern template SampleResult radiance(const World&, std::uint64_t, const SampleId&, NoObserver&);

}  // namespace rayscope::trace
