// Compress operations without vector instructions.
#include "bvh/kernel/ray_setup.h"

namespace rayscope::bvh::kernel {
namespace {

/// Copies those of eight integers whose bit is set; returns their number. `to` has room for eight.
RAYSCOPE_INLINE uint32_t compress(unsigned mask, const uint32_t* from, uint32_t* to) {
    uint32_t count = 0;
    for (; mask != 0; mask &= mask - 1) to[count++] = from[__builtin_ctz(mask)];
    return count;
}

/// Copies the items of a list whose byte has the bit set; returns their number. `to` has room for sixteen
/// more.
RAYSCOPE_INLINE uint32_t gatherByBit(const uint8_t* bytes, int bit, const uint32_t* list, uint32_t count,
                                     uint32_t* to) {
    uint32_t gathered = 0;
    for (uint32_t i = 0; i < count; ++i) {
        to[gathered] = list[i];
        gathered += static_cast<uint32_t>(bytes[i] >> bit & 1);
    }
    return gathered;
}

}  // namespace
}  // namespace rayscope::bvh::kernel
