// Eight floats at a time with AVX-512 (F, VL, BW, DQ). See lanes_portable.inl for what the functions mean.
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
    return _mm256_cmp_ps_mask(a.value, b.value, _CMP_LE_OQ);
}
RAYSCOPE_INLINE unsigned less(Lanes a, Lanes b) { return _mm256_cmp_ps_mask(a.value, b.value, _CMP_LT_OQ); }
RAYSCOPE_INLINE unsigned lessOrEqual(Lanes a, Lanes b, Lanes entry, Lanes& nearest) {
    const __mmask8 mask = _mm256_cmp_ps_mask(a.value, b.value, _CMP_LE_OQ);
    nearest.value = _mm256_mask_min_ps(nearest.value, mask, nearest.value, entry.value);
    return mask;
}

RAYSCOPE_INLINE uint32_t compress(unsigned mask, const uint32_t* from, uint32_t* to) {
    const __m256i words = _mm256_load_si256(reinterpret_cast<const __m256i*>(from));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_maskz_compress_epi32(static_cast<__mmask8>(mask), words));
    return static_cast<uint32_t>(__builtin_popcount(mask));
}

RAYSCOPE_INLINE uint32_t gatherByBit(const uint8_t* bytes, int bit, const uint32_t* list, uint32_t count,
                                     uint32_t* to) {
    const __m128i wanted = _mm_set1_epi8(static_cast<char>(1 << bit));
    uint32_t gathered = 0;
    for (uint32_t i = 0; i < count; i += 16) {
        const __m128i group = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes + i));
        const __mmask16 present = static_cast<__mmask16>(count - i < 16 ? (1u << (count - i)) - 1u : 0xffffu);
        const __mmask16 mask = _mm_mask_test_epi8_mask(present, group, wanted);
        _mm512_storeu_si512(to + gathered, _mm512_maskz_compress_epi32(mask, _mm512_loadu_si512(list + i)));
        gathered += static_cast<uint32_t>(__builtin_popcount(mask));
    }
    return gathered;
}

}  // namespace
}  // namespace rayscope::bvh::kernel
