#pragma once
// A ray prepared in float only, for conservative tests.
#include "bvh/kernel/ray_setup.h"

namespace rayscope::bvh::kernel {

/// Distances to planes are plane · inverse + constant, as in units of a BoxRay.
///
/// Against exact arithmetic they are off by at most 2u times the distance and 3u times the constant
/// (u = 2^-24); tests that move near planes 16u of the distance and 8u of the constant nearer, and far planes
/// farther, find all that kernel::intersectBox() finds, which itself moves them by no more than 10u.
struct FastRay {
    Float4 inverse, constant;  ///< the first three elements are used
    float tMin;                ///< scaled, not negative
    float scale;               ///< power of two: distance = t * scale

    /// The ray must be traceable. Multiplication by a power of two is exact, and its latency is shorter than
    /// that of a division by it; where the reciprocal alone overflows, the ray is not in range.
    RAYSCOPE_INLINE void prepare(RayData ray) {
        const Float4 direction = load4(ray + 3);
        const Float4 scales = powerOfTwoBelow(maxComponentBroadcast(absolute(direction)));
        inverse = 1.0f / direction * scales;
        constant = -load4(ray) * inverse;
        scale = scales[0];
        tMin = (ray[6] > 0.0f ? ray[6] : 0.0f) * scale;
    }

    /// Whether planes with coordinates up to ±`maxCoordinate` give no infinity, NaN or denormal scale.
    /// Otherwise the ray has to be tested with kernel::intersectBox().
    RAYSCOPE_INLINE bool isInRange(float maxCoordinate) const {
        const float farthest = maxComponent(absolute(constant) + absolute(inverse) * (maxCoordinate + 1.0f));
        return (farthest < 0x1p120f) & (scale > 0x1p-100f) & (scale < 0x1p100f);
    }
};

/// A FastRay in streams.
struct PackedRay {
    float inverse[3], constant[3];
    float pad;  ///< 8u of the maxCoordinate constant
    float tMin, scale;

    RAYSCOPE_INLINE FastRay unpacked() const { return {load4(inverse), load4(constant), tMin, scale}; }
};

/// The space in which a ray runs along z, in float. Prepared at the first leaf.
struct FastShear {
    Float4 origin, direction;  ///< in the order of the axes
    RayAxes axes;
    bool isReady;
    float shearX, shearY;
    float scaleZ;  ///< from z to distance

    RAYSCOPE_INLINE void prepareOnce(RayData ray, float scale) {
        if (isReady) return;
        isReady = true;
        axes = RayAxes(ray);
        origin = axes.permuted(ray);
        direction = axes.permuted(ray + 3);
        shearX = direction[0] / direction[2];
        shearY = direction[1] / direction[2];
        scaleZ = scale / direction[2];
    }
};

}  // namespace rayscope::bvh::kernel
