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

/// "mesh 0 'dragon'" or "sphere 2 'bulb'": the object with this number in the scene.
std::string objectName(const trace::World& world, int object);

}  // namespace rayscope::probe
