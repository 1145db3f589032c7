#pragma once
#include <rayscope/render_session.h>
#include <string>

namespace rayscope::cli {

/// Counts, times and settings of a render, as JSON.
std::string renderStatsJson(const RenderRequest& request, const RenderStatus& status,
                            const trace::World& world, int threads, double totalSeconds);

}  // namespace rayscope::cli
