#pragma once
// Rays prepared for tests against boxes and triangles; README.md lists all types of rays.
//
// The files of this folder are compiled once per instruction set. They hold plain data and functions that are
// always inlined, and include nothing else: an inline function of another header, compiled for AVX, might
// become the linker's copy for all callers.
#include <stdint.h>

namespace rayscope::bvh::kernel {

#define RAYSCOPE_INLINE [[gnu::always_inline]] inline

constexpr float kInfinity = __builtin_inff();
constexpr float kMaxFloat = __FLT_MAX__;
constexpr uint32_t kNoPrimitive = 0xffffffffu;

/// The eight floats of a Ray: origin, direction, tMin, tMax.
using RayData = const float*;

using Float4 = float __attribute__((vector_size(16)));
using Int4 = int32_t __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));

RAYSCOPE_INLINE Float4 load4(const float* from) {
    Float4 to;
    __builtin_memcpy(&to, from, sizeof to);
    return to;
}
RAYSCOPE_INLINE Float4 absolute(Float4 x) {
    return __builtin_bit_cast(Float4, __builtin_bit_cast(Int4, x) & 0x7fffffff);
}
RAYSCOPE_INLINE float maxComponent(Float4 x) {
    const float ab = x[0] > x[1] ? x[0] : x[1];
    return x[2] > ab ? x[2] : ab;
}

/// The same in all elements.
RAYSCOPE_INLINE Float4 maxComponentBroadcast(Float4 x) {
    const Float4 second = __builtin_shufflevector(x, x, 1, 2, 0, 1),
                 third = __builtin_shufflevector(x, x, 2, 0, 1, 2);
    const Float4 larger = second > third ? second : third, first = __builtin_shufflevector(x, x, 0, 1, 2, 0);
    return first > larger ? first : larger;
}

/// 2^k with 2^k <= x < 2^(k+1), for positive normal x.
RAYSCOPE_INLINE Float4 powerOfTwoBelow(Float4 x) {
    return __builtin_bit_cast(Float4, __builtin_bit_cast(Int4, x) & 0x7f800000);
}
RAYSCOPE_INLINE float powerOfTwoBelow(float x) {
    return __builtin_bit_cast(float, __builtin_bit_cast(uint32_t, x) & 0x7f800000u);
}

/// The scaled distance beyond which there are no hits: that of tMax, or of the largest float.
RAYSCOPE_INLINE float scaledTMax(float tMax, double scale) {
    return static_cast<float>((tMax < kMaxFloat ? tMax : kMaxFloat) * scale);
}

/// Whether the ray can hit anything: finite, with a direction that is not zero and an interval (tMin, tMax]
/// that is not empty.
RAYSCOPE_INLINE bool isTraceable(RayData ray) {
    const Float4 direction = load4(ray + 3);
    const Float4 nothing = load4(ray) * 0.0f + direction * 0.0f;  // NaN for infinity and NaN
    const bool finite = nothing[0] + nothing[1] + nothing[2] == 0.0f;
    return finite & (maxComponent(absolute(direction)) > 0.0f) & (ray[6] < ray[7]) & (ray[7] > 0.0f);
}

/// For the test against boxes; see intersect_box.h. The direction must be finite and not zero. Of all vectors
/// the first three elements are used.
///
/// Distances are measured in units of the direction divided by a power of two, chosen so that its longest
/// component lies in [1, 2): nothing overflows or underflows because of the length of the direction.
struct BoxRay {
    Float4 origin;
    Float4 nearInverse;
    Float4 farInverse;
    Int4 backward;  ///< −1 where the near plane is the upper one, else 0
    float tMin;     ///< scaled; a negative tMin counts as 0
    float tMax;     ///< scaled
    double scale;   ///< power of two: distance = t * scale

    RAYSCOPE_INLINE explicit BoxRay(RayData ray) : BoxRay(load4(ray), load4(ray + 3), ray[6], ray[7]) {}
    RAYSCOPE_INLINE BoxRay(Float4 from, Float4 direction, float t0, float t1) : origin(from) {
        constexpr double kPad = 0x1p-21;  // 8u
        backward = __builtin_bit_cast(Int4, direction) < 0;
        const double longest = maxComponent(absolute(direction));
        scale = __builtin_bit_cast(double, __builtin_bit_cast(uint64_t, longest) & 0x7ff0000000000000u);
        tMin = distance(t0 > 0.0f ? t0 : 0.0f);
        tMax = distance(t1);
        const Double4 inverse = scale / __builtin_convertvector(direction, Double4);
        const Float4 shorter = __builtin_convertvector(inverse * (1.0 - kPad), Float4);
        farInverse = __builtin_convertvector(inverse * (1.0 + kPad), Float4);
        // A near distance must not become infinite because the reciprocal did; a far distance may.
        const Float4 above = shorter > kMaxFloat ? Float4{} + kMaxFloat : shorter;
        const Float4 finite = above < -kMaxFloat ? Float4{} - kMaxFloat : above;
        nearInverse = direction == 0.0f ? shorter : finite;
    }

    /// The scaled t; never below any float distance that does not exceed the true value.
    RAYSCOPE_INLINE float distance(float t) const { return static_cast<float>(t * scale); }
};

/// The axes of the space in which a ray runs along z: the longest component of its direction comes last, and
/// the winding is kept.
struct RayAxes {
    int32_t kx, ky, kz;

    RayAxes() = default;
    RAYSCOPE_INLINE explicit RayAxes(RayData ray) {
        const float* direction = ray + 3;
        const float x = __builtin_fabsf(direction[0]), y = __builtin_fabsf(direction[1]),
                    z = __builtin_fabsf(direction[2]);
        kz = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
        const int32_t first = kz == 2 ? 0 : kz + 1;
        const int32_t second = first == 2 ? 0 : first + 1;
        const bool backward = direction[kz] < 0.0f;
        kx = backward ? second : first;
        ky = backward ? first : second;
    }

    /// Three numbers, x y z, in the order of these axes.
    RAYSCOPE_INLINE Float4 permuted(const float* from) const {
        return Float4{from[kx], from[ky], from[kz], 0.0f};
    }
};

/// For the test against triangles; see intersect_triangle.h. The direction must be finite and not zero.
struct ShearedRay {
    double origin[3];
    double shearX, shearY, scaleZ;
    int kx, ky, kz;  ///< axes, z being the one along which the direction is longest

    RAYSCOPE_INLINE explicit ShearedRay(RayData ray) {
        const RayAxes axes(ray);
        kx = axes.kx;
        ky = axes.ky;
        kz = axes.kz;
        for (int axis = 0; axis < 3; ++axis) origin[axis] = ray[axis];
        const double along = ray[3 + kz];
        shearX = ray[3 + kx] / along;
        shearY = ray[3 + ky] / along;
        scaleZ = 1.0 / along;
    }
};

}  // namespace rayscope::bvh::kernel
