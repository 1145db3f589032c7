#pragma once
// Images of other things than radiance ("arbitrary output variables").
#include <rayscope/image.h>
#include <rayscope/render_session.h>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

namespace rayscope::probe {

enum class Aov {
    Normal,
    Depth,
    Uv,
    Primitive,
    Material,  // of the surface behind the centre of the pixel
    Nodes,
    Triangles,
    Rays,
    Time,
    NonFinite,  // of the samples, replayed
    Samples,
    Variance,
    Error  // of the film
};

struct AovInfo {
    Aov aov;
    std::string_view name;  ///< on the command line and in file names
    std::string_view help;
    bool isColor;  ///< three channels that differ; else one number in all three
};
std::span<const AovInfo> aovTable();
const AovInfo& infoOf(Aov aov);
/// Throws InputError that names the nearest one.
Aov aovNamed(std::string_view name);

/// What a sample of a pixel costs, as the mean over its first samples.
struct SampleCost {
    double nodes = 0.0, tests = 0.0, rays = 0.0;
};
SampleCost costAt(const trace::World& world, std::uint64_t seed, int x, int y, int samples);

/// What the images are made of.
struct AovRequest {
    const trace::World& world;
    const render::Film* film = nullptr;  ///< for samples, variance and error; without one these are 0
    std::uint64_t seed = 0;
    int samples = 1;  ///< per pixel, that are replayed for what is counted and timed
    std::optional<PixelBounds> region = std::nullopt;  ///< absent: the whole image; outside it pixels are 0
    int threads = 0;                                   ///< 0: one per core
    std::stop_token stop{};                            ///< throws Stopped
};

/// One image per wanted quantity. Where there is no surface, normal, depth and uv are 0, primitive and
/// material −1.
std::vector<RgbImage> renderAovs(const AovRequest& request, std::span<const Aov> wanted);

}  // namespace rayscope::probe
