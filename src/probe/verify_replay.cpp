#include <rayscope/probe.h>
#include <bit>
#include <cstring>

#include "render/film.h"

namespace rayscope {

namespace {
/// Bit for bit: unlike ==, this tells 0 from −0 and finds a NaN equal to itself.
bool sameBits(const RgbSum& a, const RgbSum& b) { return std::memcmp(&a, &b, sizeof(RgbSum)) == 0; }
}  // namespace

ReplayResult verifyReplay(const trace::World& world, const render::Film& film, std::uint64_t seed, int x,
                          int y, const std::function<void()>& beforeSample) {
    ReplayResult verdict;
    verdict.film = film.sums(x, y, verdict.samples).radiance;
    verdict.sumMatches = true;
    for (int index = 0; index < verdict.samples; ++index) {
        if (beforeSample) beforeSample();
        const RayTree tree = probeSample(world, seed, {x, y, index});
        RgbSum sum(0.0);
        for (const RgbSum& addend : tree.addends) sum += addend;
        verdict.sumMatches = verdict.sumMatches && sameBits(sum, tree.radiance);
        verdict.replayed += tree.radiance;
        verdict.values.push_back(tree.radiance);
    }
    verdict.matchesFilm = sameBits(verdict.film, verdict.replayed);
    return verdict;
}

}  // namespace rayscope
