#pragma once
// AOVs ("arbitrary output variables"): images of something other than radiance.
#include <rayscope/image.h>
#include <rayscope/render_image.h>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope {

/// In the order of aovTable().
enum class Aov {
    // Of the surface behind the centre of the pixel:
    Normal,
    Depth,
    Uv,
    Primitive,
    Material,
    // Of replayed samples:
    Nodes,
    Triangles,
    Rays,
    Time,
    NonFinite,
    // Of the film:
    Samples,
    Variance,
    Error
};

struct AovInfo {
    Aov aov;
    std::string_view name;  ///< on the command line and in file names
    std::string_view help;
    bool isColor;  ///< three channels; otherwise one number in all three
    bool isOfFilm() const { return aov >= Aov::Samples; }
};
/// All AOVs.
std::span<const AovInfo> aovTable();
const AovInfo& infoOf(Aov aov);
/// Throws InputError with the nearest name.
Aov aovNamed(std::string_view name);

struct AovRequest {
    const trace::World& world;
    const render::Film* film = nullptr;  ///< for samples, variance and error; without one these are 0
    std::uint64_t seed = 0;
    int samples = 1;                                   ///< replayed per pixel for counts and times
    std::optional<PixelBounds> region = std::nullopt;  ///< absent: the whole image; outside it pixels are 0
    int threads = 0;                                   ///< 0: one per core
    std::stop_token stop{};                            ///< throws Stopped
};

/// One image per wanted quantity. Where there is no surface, normal, depth and uv are 0, primitive and
/// material −1. Throws std::invalid_argument if the region is not within the image or samples is below 1.
std::vector<RgbImage> renderAovs(const AovRequest& request, std::span<const Aov> wanted);

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
