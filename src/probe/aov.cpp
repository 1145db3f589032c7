#include <rayscope/aov.h>

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <cmath>

#include "base/check_argument.h"
#include "base/memory_budget.h"
#include "base/nearest_name.h"
#include "math/vectors.h"
#include "probe/sample_cost.h"
#include "render/film.h"
#include "render/thread_arena.h"
#include "trace/interaction.h"
#include "trace/world.h"

namespace rayscope {

namespace {

// clang-format off
constexpr AovInfo kTable[] = {
    {Aov::Normal, "normal", "shading normal, -1 to 1 in world space", true},
    {Aov::Depth, "depth", "distance along the viewing direction, scene units", false},
    {Aov::Uv, "uv", "texture coordinates, in red and green", true},
    {Aov::Primitive, "primitive", "number of the triangle or sphere; -1: none", false},
    {Aov::Material, "material", "number of the material; -1: none", false},
    {Aov::Nodes, "nodes", "BVH nodes visited, leaves included, in the layout of the settings; per sample", false},
    {Aov::Triangles, "triangles", "triangles and spheres tested in these leaves; per sample", false},
    {Aov::Rays, "rays", "rays traced, per sample", false},
    {Aov::Time, "time", "microseconds per sample, as measured", false},
    {Aov::NonFinite, "nan", "samples that are NaN or infinite", false},
    {Aov::Samples, "samples", "samples taken", false},
    {Aov::Variance, "variance", "variance of the luminance of a sample", false},
    {Aov::Error, "error", "standard error of the luminance of the pixel", false},
};
// clang-format on

Rgb grey(double value) { return Rgb(static_cast<float>(value)); }

/// The surface behind the centre of a pixel, through the centre of the lens, at the start of the shutter.
std::optional<trace::Interaction> surfaceAt(const trace::World& world, int x, int y) {
    const Ray ray = world.camera.pinholeRay(glm::dvec2(x, y) + 0.5);
    Hit hit;
    if (!world.closestHit(ray, 0.0f, hit)) return std::nullopt;
    return trace::interactionAt(world, ray, 0.0f, {0.0, world.camera.pixelAngle()}, hit);
}

Rgb surfaceValue(const trace::World& world, const std::optional<trace::Interaction>& at, Aov aov) {
    const bool isNumber = aov == Aov::Primitive || aov == Aov::Material;
    if (!at) return grey(isNumber ? -1.0 : 0.0);
    switch (aov) {
        case Aov::Normal:
            return Rgb(at->normal);
        case Aov::Depth:
            return grey(world.camera.depthOf(at->position));
        case Aov::Uv:
            return {at->uv.x, at->uv.y, 0.0f};
        case Aov::Primitive:
            return grey(at->hit.primitive);
        default:
            return grey(at->material);
    }
}

Rgb filmValue(const render::Film* film, int x, int y, Aov aov) {
    int samples = 0;
    if (film == nullptr) return grey(0.0);
    const render::PixelSums sums = film->sums(x, y, samples);
    if (aov == Aov::Samples) return grey(samples);
    if (samples < 2) return grey(0.0);
    const double n = samples, mean = math::luminance(sums.radiance) / n;
    const double variance = std::max(0.0, (sums.squaredLuminance / n - mean * mean) * n / (n - 1.0));
    return grey(aov == Aov::Variance ? variance : std::sqrt(variance / n));
}

Rgb costValue(const probe::SampleCost& cost, Aov aov) {
    switch (aov) {
        case Aov::Nodes:
            return grey(cost.nodes);
        case Aov::Triangles:
            return grey(cost.tests);
        case Aov::Rays:
            return grey(cost.rays);
        case Aov::Time:
            return grey(cost.microseconds);
        default:
            return grey(cost.nonFinite);
    }
}

bool isOfSurface(Aov aov) { return aov <= Aov::Material; }
bool isOfFilm(Aov aov) { return infoOf(aov).isOfFilm(); }

}  // namespace

std::span<const AovInfo> aovTable() { return kTable; }

const AovInfo& infoOf(Aov aov) { return kTable[static_cast<std::size_t>(aov)]; }

Aov aovNamed(std::string_view name) {
    std::vector<std::string_view> names;
    for (const AovInfo& info : kTable) {
        if (info.name == name) return info.aov;
        names.push_back(info.name);
    }
    throw InputError(fmt::format("unknown AOV '{}'{}; expected {}", name,
                                 base::didYouMean(std::string(name), names), fmt::join(names, ", ")));
}

std::vector<RgbImage> renderAovs(const AovRequest& request, std::span<const Aov> wanted) {
    const trace::World& world = request.world;
    const PixelBounds region = request.region.value_or(PixelBounds{0, world.width, 0, world.height});
    base::checkArgument(region.x0 >= 0 && region.x0 <= region.x1 && region.x1 <= world.width &&
                            region.y0 >= 0 && region.y0 <= region.y1 && region.y1 <= world.height,
                        "region is outside the image");
    base::checkArgument(request.samples >= 1, "samples is {}; expected at least 1", request.samples);
    base::requireMemory(wanted.size() * static_cast<std::uint64_t>(world.width) *
                            static_cast<std::uint64_t>(world.height) * sizeof(Rgb),
                        "fewer AOVs, a smaller image (--size)", "{} AOVs of {} x {} pixels", wanted.size(),
                        world.width, world.height);
    std::vector<RgbImage> images(wanted.size(), RgbImage(world.width, world.height));
    const auto wants = [&](auto&& condition) { return std::any_of(wanted.begin(), wanted.end(), condition); };
    const bool surface = wants(isOfSurface);
    const bool costs = wants([](Aov aov) { return !isOfSurface(aov) && !isOfFilm(aov); });
    const bool counted = wants([](Aov aov) { return aov == Aov::Nodes || aov == Aov::Triangles; });
    const auto renderRow = [&](int y) {
        for (int x = region.x0; x < region.x1; ++x) {
            if (request.stop.stop_requested()) return;
            const auto at = surface ? surfaceAt(world, x, y) : std::nullopt;
            const probe::SampleCost cost =
                costs ? probe::costAt(world, request.seed, x, y, request.samples, counted, request.stop)
                      : probe::SampleCost{};
            for (std::size_t i = 0; i < wanted.size(); ++i)
                images[i].at(x, y) = isOfSurface(wanted[i]) ? surfaceValue(world, at, wanted[i])
                                     : isOfFilm(wanted[i])  ? filmValue(request.film, x, y, wanted[i])
                                                            : costValue(cost, wanted[i]);
        }
    };
    render::ThreadArena arena(request.threads);
    arena.run([&] { oneapi::tbb::parallel_for(region.y0, region.y1, renderRow); });
    if (request.stop.stop_requested()) throw Stopped{};
    return images;
}

}  // namespace rayscope
