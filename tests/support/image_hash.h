#pragma once
#include <cstring>

#include "render/film.h"
#include "sampling/hash.h"

namespace rayscope::test {

/// A hash of all bits of all sums and sample counts.
inline std::uint64_t hashOf(const render::Film& film) {
    std::uint64_t hash = 0;
    render::Film::TileCopy copy;
    for (int tile = 0; tile < film.tileCount(); ++tile) {
        film.read(tile, copy);
        hash = sampling::hashPair(hash, static_cast<std::uint64_t>(copy.samples));
        for (const render::PixelSums& pixel : copy.pixels) {
            const double values[4] = {pixel.radiance.x, pixel.radiance.y, pixel.radiance.z,
                                      pixel.squaredLuminance};
            for (const double value : values) {
                std::uint64_t bits = 0;
                std::memcpy(&bits, &value, sizeof bits);
                hash = sampling::hashPair(hash, bits);
            }
        }
    }
    return hash;
}

}  // namespace rayscope::test
