#pragma once
#include <rayscope/probe.h>

namespace rayscope::probe {

/// Where the first value of a sample came up that is not a number, or more than a float holds, in words;
/// empty if there is none.
std::string causeOfNonFinite(const RayTree& tree, const trace::World& world);

}  // namespace rayscope::probe
