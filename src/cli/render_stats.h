#pragma once
#include <rayscope/render_session.h>
#include <string>

namespace rayscope {

/// Everything that was counted and timed, as JSON.
std::string renderStatsJson(const RenderRequest& request, const RenderStatus& status, const World& world,
                            int threads, double totalSeconds);

}  // namespace rayscope
