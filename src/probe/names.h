#pragma once
#include <string_view>

#include "probe/traversal_log.h"

namespace rayscope::probe {

std::string_view nameOf(TraversalEvent event);

}  // namespace rayscope::probe
