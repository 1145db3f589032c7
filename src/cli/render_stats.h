#pragma once
#include <rayscope/image.h>
#include <rayscope/render_session.h>
#include <string>

namespace rayscope {

/// What travels inside an image file: program and version, scene, settings, seed, samples.
ImageMetadata imageMetadata(const RenderRequest& request, const RenderStatus& status);

/// Everything that was counted and timed, as JSON.
std::string renderStatsJson(const RenderRequest& request, const RenderStatus& status, const World& world,
                            int threads, double totalSeconds);

}  // namespace rayscope
