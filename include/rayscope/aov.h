#pragma once
// AOVs ("arbitrary output variables"): images of something other than radiance.
#include <rayscope/image.h>
#include <rayscope/render_image.h>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope {

/// "normal", "depth", "uv", "primitive", "material", "nodes", …: the names that renderAovs() accepts.
std::vector<std::string_view> aovNames();

struct AovOptions {
    int threads = 0;         ///< 0: one per core
    std::stop_token stop{};  ///< throws Stopped
};

/// One image per name, in the same order; numbers are in all three channels. Pixels outside the region of the
/// render are 0. Without a surface, normal, depth and uv are 0, primitive and material −1. Throws
/// InputError with the nearest name if one is unknown, and std::invalid_argument if `image` has no world.
std::vector<RgbImage> renderAovs(const RenderedImage& image, std::span<const std::string> names,
                                 const AovOptions& options = {});

}  // namespace rayscope
