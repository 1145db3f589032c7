#include <rayscope/probe.h>
#include <bit>
#include <cstring>

#include "base/check_argument.h"
#include "render/film.h"

namespace rayscope {

namespace {
/// Bit for bit: unlike with ==, 0 and −0 differ, and a NaN equals itself.
bool sameBits(const RgbSum& a, const RgbSum& b) { return std::memcmp(&a, &b, sizeof(RgbSum)) == 0; }
}  // namespace

ReplayResult verifyReplay(const trace::World& world, const render::Film& film, std::uint64_t seed, int x,
                          int y, const std::function<void()>& beforeSample, const std::stop_token& stop) {
    base::checkArgument(film.region().contains(x, y), "pixel {}, {} is outside the film", x, y);
    ReplayResult result;
    result.film = film.sums(x, y, result.samples).radiance;
    result.sumMatches = true;
    for (int index = 0; index < result.samples; ++index) {
        if (beforeSample) beforeSample();
        const RayTree tree = probeSample(world, seed, {x, y, index}, stop);
        RgbSum sum(0.0);
        for (const RgbSum& addend : tree.addends) sum += addend;
        result.sumMatches = result.sumMatches && sameBits(sum, tree.radiance);
        result.replayed += tree.radiance;
        result.values.push_back(tree.radiance);
    }
    result.matchesFilm = sameBits(result.film, result.replayed);
    return result;
}

}  // namespace rayscope
