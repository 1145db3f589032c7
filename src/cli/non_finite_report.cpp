#include "cli/non_finite_report.h"

#include <fmt/format.h>

#include <rayscope/probe.h>
#include <string>

#include "base/console.h"
#include "math/vectors.h"
#include "probe/non_finite.h"
#include "render/film.h"
#include "render/probe_command.h"

namespace rayscope::cli {

namespace {

/// The first sample of a pixel that is not finite, and why; sample 0 if each of them is finite.
struct NonFiniteSample {
    int index = 0;
    std::string cause = "the sum of its samples overflows";
};

NonFiniteSample firstNonFiniteSample(const RenderedImage& image, glm::ivec2 pixel) {
    int samples = image.status.samples;
    if (image.film) image.film->sums(pixel.x, pixel.y, samples);
    for (int index = 0; index < samples; ++index) {
        const RayTree tree = probeSample(*image.world, image.request.seed, {pixel.x, pixel.y, index});
        if (std::string cause = probe::causeOfNonFinite(tree, *image.world); !cause.empty())
            return {index, cause};
    }
    return {};
}

}  // namespace

bool reportNonFinite(const RenderedImage& image) {
    const RgbImage& mean = image.mean;
    constexpr int kNamed = 8;
    int count = 0;
    std::string names;
    glm::ivec2 first(0);
    for (int y = 0; y < mean.height; ++y) {
        for (int x = 0; x < mean.width; ++x) {
            if (math::isFinite(mean.at(x, y))) continue;
            if (count == 0) first = {x, y};
            if (count++ < kNamed) names += fmt::format(" ({}, {})", x, y);
        }
    }
    if (count == 0) return false;
    const NonFiniteSample sample = firstNonFiniteSample(image, first);
    base::printMessage("error: {} pixels are NaN or infinite:{}{}; in the first, {}; to inspect it: {}\n",
                       count, names, count > kNamed ? " …" : "", base::printable(sample.cause),
                       render::probeCommand(image.request, {first.x, first.y, sample.index}));
    return true;
}

}  // namespace rayscope::cli
