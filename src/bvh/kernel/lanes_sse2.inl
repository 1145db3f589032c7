// Eight floats at a time, as two halves with SSE2. See lanes_portable.inl for what the functions mean.
#include <emmintrin.h>

#include "bvh/kernel/ray_setup.h"

namespace rayscope::bvh::kernel {
namespace {

struct Lanes {
    __m128 low, high;

    RAYSCOPE_INLINE static Lanes load(const float* from) {
        return {_mm_load_ps(from), _mm_load_ps(from + 4)};
    }
    RAYSCOPE_INLINE static Lanes loadUnaligned(const float* from) {
        return {_mm_loadu_ps(from), _mm_loadu_ps(from + 4)};
    }
    RAYSCOPE_INLINE static Lanes broadcast(float x) { return {_mm_set1_ps(x), _mm_set1_ps(x)}; }
    RAYSCOPE_INLINE void store(float* to) const {
        _mm_store_ps(to, low);
        _mm_store_ps(to + 4, high);
    }
};

RAYSCOPE_INLINE Lanes operator+(Lanes a, Lanes b) {
    return {_mm_add_ps(a.low, b.low), _mm_add_ps(a.high, b.high)};
}
RAYSCOPE_INLINE Lanes operator-(Lanes a, Lanes b) {
    return {_mm_sub_ps(a.low, b.low), _mm_sub_ps(a.high, b.high)};
}
RAYSCOPE_INLINE Lanes operator*(Lanes a, Lanes b) {
    return {_mm_mul_ps(a.low, b.low), _mm_mul_ps(a.high, b.high)};
}

RAYSCOPE_INLINE Lanes minimum(Lanes a, Lanes b) {
    return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)};
}
RAYSCOPE_INLINE Lanes maximum(Lanes a, Lanes b) {
    return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)};
}
RAYSCOPE_INLINE Lanes absolute(Lanes a) {
    const __m128 sign = _mm_set1_ps(-0.0f);
    return {_mm_andnot_ps(sign, a.low), _mm_andnot_ps(sign, a.high)};
}
RAYSCOPE_INLINE Lanes flipSign(Lanes a, Lanes b) {
    const __m128 sign = _mm_set1_ps(-0.0f);
    return {_mm_xor_ps(a.low, _mm_and_ps(sign, b.low)), _mm_xor_ps(a.high, _mm_and_ps(sign, b.high))};
}
RAYSCOPE_INLINE Lanes multiplyAdd(Lanes a, Lanes b, Lanes c) { return a * b + c; }
RAYSCOPE_INLINE Lanes subtractProduct(Lanes c, Lanes a, Lanes b) { return c - a * b; }

RAYSCOPE_INLINE unsigned bitsOf(__m128 low, __m128 high) {
    return static_cast<unsigned>(_mm_movemask_ps(low) | _mm_movemask_ps(high) << 4);
}
RAYSCOPE_INLINE unsigned lessOrEqual(Lanes a, Lanes b) {
    return bitsOf(_mm_cmple_ps(a.low, b.low), _mm_cmple_ps(a.high, b.high));
}
RAYSCOPE_INLINE unsigned less(Lanes a, Lanes b) {
    return bitsOf(_mm_cmplt_ps(a.low, b.low), _mm_cmplt_ps(a.high, b.high));
}
RAYSCOPE_INLINE __m128 minimumWhere(__m128 mask, __m128 a, __m128 b) {
    const __m128 elsewhere = _mm_andnot_ps(mask, _mm_set1_ps(kInfinity));
    return _mm_min_ps(_mm_or_ps(_mm_and_ps(mask, a), elsewhere), b);
}
RAYSCOPE_INLINE unsigned lessOrEqual(Lanes a, Lanes b, Lanes entry, Lanes& nearest) {
    const __m128 low = _mm_cmple_ps(a.low, b.low), high = _mm_cmple_ps(a.high, b.high);
    nearest = {minimumWhere(low, entry.low, nearest.low), minimumWhere(high, entry.high, nearest.high)};
    return bitsOf(low, high);
}

}  // namespace
}  // namespace rayscope::bvh::kernel
