// Eight floats at a time with AVX2, FMA and BMI2. See lanes_portable.inl for what the functions mean.
#include <immintrin.h>

#include "bvh/kernel/ray_setup.h"

namespace rayscope::bvh::kernel {
namespace {

struct Lanes {
    __m256 value;

    RAYSCOPE_INLINE static Lanes load(const float* from) { return {_mm256_load_ps(from)}; }
    RAYSCOPE_INLINE static Lanes loadUnaligned(const float* from) { return {_mm256_loadu_ps(from)}; }
    RAYSCOPE_INLINE static Lanes broadcast(float x) { return {_mm256_set1_ps(x)}; }
    RAYSCOPE_INLINE void store(float* to) const { _mm256_store_ps(to, value); }
};

RAYSCOPE_INLINE Lanes operator+(Lanes a, Lanes b) { return {_mm256_add_ps(a.value, b.value)}; }
RAYSCOPE_INLINE Lanes operator-(Lanes a, Lanes b) { return {_mm256_sub_ps(a.value, b.value)}; }
RAYSCOPE_INLINE Lanes operator*(Lanes a, Lanes b) { return {_mm256_mul_ps(a.value, b.value)}; }

RAYSCOPE_INLINE Lanes minimum(Lanes a, Lanes b) { return {_mm256_min_ps(a.value, b.value)}; }
RAYSCOPE_INLINE Lanes maximum(Lanes a, Lanes b) { return {_mm256_max_ps(a.value, b.value)}; }
RAYSCOPE_INLINE Lanes absolute(Lanes a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.value)}; }
RAYSCOPE_INLINE Lanes flipSign(Lanes a, Lanes b) {
    return {_mm256_xor_ps(a.value, _mm256_and_ps(_mm256_set1_ps(-0.0f), b.value))};
}
RAYSCOPE_INLINE Lanes multiplyAdd(Lanes a, Lanes b, Lanes c) {
    return {_mm256_fmadd_ps(a.value, b.value, c.value)};
}
RAYSCOPE_INLINE Lanes subtractProduct(Lanes c, Lanes a, Lanes b) {
    return {_mm256_fnmadd_ps(a.value, b.value, c.value)};
}

RAYSCOPE_INLINE unsigned lessOrEqual(Lanes a, Lanes b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.value, b.value, _CMP_LE_OQ)));
}
RAYSCOPE_INLINE unsigned less(Lanes a, Lanes b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.value, b.value, _CMP_LT_OQ)));
}
RAYSCOPE_INLINE unsigned lessOrEqual(Lanes a, Lanes b, Lanes entry, Lanes& nearest) {
    const __m256 mask = _mm256_cmp_ps(a.value, b.value, _CMP_LE_OQ);
    const __m256 elsewhere = _mm256_set1_ps(kInfinity);
    nearest.value = _mm256_min_ps(_mm256_blendv_ps(elsewhere, entry.value, mask), nearest.value);
    return static_cast<unsigned>(_mm256_movemask_ps(mask));
}

/// Packs the integers whose byte in `chosen` is 1.
RAYSCOPE_INLINE uint32_t pack(uint64_t chosen, __m256i words, uint32_t* to) {
    const uint64_t lanes = _pext_u64(0x0706050403020100u, chosen * 0xffu);
    const __m256i order = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<int64_t>(lanes)));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(words, order));
    return static_cast<uint32_t>(__builtin_popcountll(chosen));
}

RAYSCOPE_INLINE uint32_t compress(unsigned mask, const uint32_t* from, uint32_t* to) {
    return pack(_pdep_u64(mask, 0x0101010101010101u),
                _mm256_load_si256(reinterpret_cast<const __m256i*>(from)), to);
}

RAYSCOPE_INLINE uint32_t gatherByBit(const uint8_t* bytes, int bit, const uint32_t* list, uint32_t count,
                                     uint32_t* to) {
    uint32_t gathered = 0;
    for (uint32_t i = 0; i < count; i += 8) {
        uint64_t chosen;
        __builtin_memcpy(&chosen, bytes + i, sizeof chosen);
        chosen = chosen >> bit & 0x0101010101010101u;
        if (count - i < 8) chosen &= (uint64_t{1} << (8 * (count - i))) - 1;
        gathered +=
            pack(chosen, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(list + i)), to + gathered);
    }
    return gathered;
}

}  // namespace
}  // namespace rayscope::bvh::kernel
