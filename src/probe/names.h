#pragma once
#include <rayscope/probe.h>
#include <string>
#include <string_view>

#include "probe/traversal_log.h"

namespace rayscope::probe {

std::string_view nameOf(RayKind kind);
std::string_view nameOf(RayEnd end);
std::string_view nameOf(Visibility visibility);
std::string_view nameOf(TraversalEvent event);

/// "mesh 0 'dragon'" or "sphere 2", as the scene calls the object with this number.
std::string objectName(const trace::World& world, int object);

}  // namespace rayscope::probe
