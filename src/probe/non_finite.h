#pragma once
#include <rayscope/probe.h>

namespace rayscope::probe {

/// Describes the first value of a sample that is not finite or exceeds the range of float; empty if there is
/// none.
std::string causeOfNonFinite(const RayTree& tree, const trace::World& world);

}  // namespace rayscope::probe
