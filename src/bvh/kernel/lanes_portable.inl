// Eight floats at a time, for every machine.
#include "bvh/kernel/ray_setup.h"

namespace rayscope::bvh::kernel {
namespace {

struct Lanes {
    float value[8];

    /// From and to addresses that are multiples of 32.
    RAYSCOPE_INLINE static Lanes load(const float* from) {
        Lanes to;
        __builtin_memcpy(to.value, from, sizeof to.value);
        return to;
    }
    RAYSCOPE_INLINE static Lanes loadUnaligned(const float* from) { return load(from); }
    RAYSCOPE_INLINE static Lanes broadcast(float x) { return {{x, x, x, x, x, x, x, x}}; }
    RAYSCOPE_INLINE void store(float* to) const { __builtin_memcpy(to, value, sizeof value); }
};

template <class F>
RAYSCOPE_INLINE Lanes eachOf(Lanes a, Lanes b, const F& f) {
    Lanes result;
    for (int i = 0; i < 8; ++i) result.value[i] = f(a.value[i], b.value[i]);
    return result;
}
template <class F>
RAYSCOPE_INLINE unsigned bitsOf(Lanes a, Lanes b, const F& f) {
    unsigned result = 0;
    for (int i = 0; i < 8; ++i) result |= (f(a.value[i], b.value[i]) ? 1u : 0u) << i;
    return result;
}

RAYSCOPE_INLINE Lanes operator+(Lanes a, Lanes b) {
    return eachOf(a, b, [](float x, float y) { return x + y; });
}
RAYSCOPE_INLINE Lanes operator-(Lanes a, Lanes b) {
    return eachOf(a, b, [](float x, float y) { return x - y; });
}
RAYSCOPE_INLINE Lanes operator*(Lanes a, Lanes b) {
    return eachOf(a, b, [](float x, float y) { return x * y; });
}

/// The second argument where either is NaN.
RAYSCOPE_INLINE Lanes minimum(Lanes a, Lanes b) {
    return eachOf(a, b, [](float x, float y) { return x < y ? x : y; });
}
RAYSCOPE_INLINE Lanes maximum(Lanes a, Lanes b) {
    return eachOf(a, b, [](float x, float y) { return x > y ? x : y; });
}
RAYSCOPE_INLINE Lanes absolute(Lanes a) {
    return eachOf(a, a, [](float x, float) { return __builtin_fabsf(x); });
}
/// a, negated where the sign bit of b is set.
RAYSCOPE_INLINE Lanes flipSign(Lanes a, Lanes b) {
    return eachOf(a, b, [](float x, float y) { return __builtin_signbit(y) ? -x : x; });
}

/// a·b + c and c − a·b, with one or two roundings.
RAYSCOPE_INLINE Lanes multiplyAdd(Lanes a, Lanes b, Lanes c) { return a * b + c; }
RAYSCOPE_INLINE Lanes subtractProduct(Lanes c, Lanes a, Lanes b) { return c - a * b; }

/// One bit per lane; 0 where either is NaN.
RAYSCOPE_INLINE unsigned lessOrEqual(Lanes a, Lanes b) {
    return bitsOf(a, b, [](float x, float y) { return x <= y; });
}
RAYSCOPE_INLINE unsigned less(Lanes a, Lanes b) {
    return bitsOf(a, b, [](float x, float y) { return x < y; });
}
/// The same; lowers `nearest` to `entry` in the lanes whose bit is set.
RAYSCOPE_INLINE unsigned lessOrEqual(Lanes a, Lanes b, Lanes entry, Lanes& nearest) {
    const unsigned mask = lessOrEqual(a, b);
    for (int i = 0; i < 8; ++i)
        if ((mask >> i & 1u) != 0 && entry.value[i] < nearest.value[i]) nearest.value[i] = entry.value[i];
    return mask;
}

}  // namespace
}  // namespace rayscope::bvh::kernel
