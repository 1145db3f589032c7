#pragma once
// Preparation of eight rays at once.
#include "bvh/kernel/fast_ray.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // about passing eight floats to functions: all of these are inlined

namespace rayscope::bvh::kernel {

using Float8 = float __attribute__((vector_size(32)));
using Int8 = int32_t __attribute__((vector_size(32)));

/// Eight vectors of eight numbers: item i of vector k becomes item k of vector i.
RAYSCOPE_INLINE void transpose(Float8 (&v)[8]) {
    Float8 pairs[8], fours[8];
    for (int i = 0; i < 8; i += 2) {
        pairs[i] = __builtin_shufflevector(v[i], v[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
        pairs[i + 1] = __builtin_shufflevector(v[i], v[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
    }
    for (int i = 0; i < 8; i += 4)
        for (int k = 0; k < 2; ++k) {
            fours[i + 2 * k] =
                __builtin_shufflevector(pairs[i + k], pairs[i + 2 + k], 0, 1, 8, 9, 4, 5, 12, 13);
            fours[i + 2 * k + 1] =
                __builtin_shufflevector(pairs[i + k], pairs[i + 2 + k], 2, 3, 10, 11, 6, 7, 14, 15);
        }
    for (int i = 0; i < 4; ++i) {
        v[i] = __builtin_shufflevector(fours[i], fours[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        v[i + 4] = __builtin_shufflevector(fours[i], fours[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
}

RAYSCOPE_INLINE Float8 absolute(Float8 x) {
    return __builtin_bit_cast(Float8, __builtin_bit_cast(Int8, x) & 0x7fffffff);
}
RAYSCOPE_INLINE Float8 larger(Float8 a, Float8 b) { return a > b ? a : b; }

RAYSCOPE_INLINE Float8 load8(const float* from) {
    Float8 to;
    __builtin_memcpy(&to, from, sizeof to);
    return to;
}
RAYSCOPE_INLINE void store8(float* to, Float8 from) { __builtin_memcpy(to, &from, sizeof from); }

/// The numbers of FastRay and FastShear for eight rays, one row per number.
struct alignas(32) RayColumns {
    float origin[3][8], direction[3][8], inverse[3][8], tMin[8];
    float shearX[8], shearY[8], scaleZ[8];  ///< after shear()

    /// All rays have the same RayAxes::kz and the same scale.
    RAYSCOPE_INLINE void shear(const RayAxes& axes, float scale) {
        const Float8 along = load8(direction[axes.kz]);
        store8(shearX, load8(direction[axes.kx]) / along);
        store8(shearY, load8(direction[axes.ky]) / along);
        store8(scaleZ, scale / along);
    }
};

/// Does what FastRay::prepare() does for eight rays of eight floats each. Returns a bit for each that is
/// traceable and in range (see isTraceable() and FastRay::isInRange()); `bound` is their scaled tMax.
RAYSCOPE_INLINE unsigned prepareEight(const float* rays, float maxCoordinate, PackedRay* prepared,
                                      float* bound, RayColumns& columns) {
    Float8 data[8];
    for (int i = 0; i < 8; ++i) data[i] = load8(rays + 8 * i);
    transpose(data);
    const Float8 longest = larger(larger(absolute(data[3]), absolute(data[4])), absolute(data[5]));
    const Float8 scale = __builtin_bit_cast(Float8, __builtin_bit_cast(Int8, longest) & 0x7f800000);
    Float8 row[8], nothing{}, steepest{}, farthest{};
    for (int axis = 0; axis < 3; ++axis) {
        const Float8 origin = data[axis], direction = data[3 + axis];
        const Float8 inverse = scale / direction, constant = -origin * inverse;
        row[axis] = inverse;
        row[3 + axis] = constant;
        nothing += origin * 0.0f + direction * 0.0f;
        steepest = larger(absolute(constant), steepest);
        farthest += absolute(constant) + absolute(inverse) * (maxCoordinate + 1.0f);
        store8(columns.origin[axis], origin);
        store8(columns.direction[axis], direction);
        store8(columns.inverse[axis], inverse);
    }
    row[6] = steepest * 0x1p-21f + 0x1p-120f;
    row[7] = (data[6] > 0.0f ? data[6] : Float8{}) * scale;
    store8(columns.tMin, row[7]);
    store8(bound, (data[7] < kMaxFloat ? data[7] : Float8{} + kMaxFloat) * scale);
    const Int8 usable = (nothing == 0.0f) & (data[6] < data[7]) & (data[7] > 0.0f) & (farthest < 0x1p120f) &
                        (scale > 0x1p-100f) & (scale < 0x1p100f);
    transpose(row);
    unsigned mask = 0;
    for (int i = 0; i < 8; ++i) {
        store8(prepared[i].inverse, row[i]);
        prepared[i].scale = scale[i];
        mask |= (static_cast<unsigned>(usable[i]) & 1u) << i;
    }
    return mask;
}

}  // namespace rayscope::bvh::kernel
