#pragma once
// A ray prepared in float only, for conservative tests.
#include "bvh/kernel/ray_setup.h"

namespace rayscope::kernel {

/// Distances to planes are plane · inverse + constant, as in units of a BoxRay.
///
/// Against exact arithmetic they are off by at most 2u times the distance and 3u times the constant
/// (u = 2^-24); tests that move near planes 16u of the distance and `pad` nearer, and far planes farther,
/// find all that kernel::intersectBox() finds, which itself moves them by no more than 10u.
struct FastRay {
    float inverse[3];
    float constant[3];
    float pad;    ///< absolute
    float tMin;   ///< scaled, not negative
    float scale;  ///< power of two: distance = t * scale

    /// The ray must be traceable.
    RAYSCOPE_INLINE void prepare(RayWords ray) {
        const Float4 direction = load4(ray + 3);
        scale = powerOfTwoBelow(largestOf3(absolute(direction)));
        const Float4 inverses = scale / direction, constants = -load4(ray) * inverses;
        for (int axis = 0; axis < 3; ++axis) {
            inverse[axis] = inverses[axis];
            constant[axis] = constants[axis];
        }
        pad = largestOf3(absolute(constants)) * 0x1p-21f + 0x1p-120f;
        tMin = (ray[6] > 0.0f ? ray[6] : 0.0f) * scale;
    }

    /// Whether no plane up to `largest` away from 0 can bring about an infinity, a NaN or a denormal scale.
    /// If not, the ray has to be tested with kernel::intersectBox().
    RAYSCOPE_INLINE bool suits(float largest) const {
        const Float4 constants = absolute(Float4{constant[0], constant[1], constant[2], 0.0f});
        const Float4 inverses = absolute(Float4{inverse[0], inverse[1], inverse[2], 0.0f});
        const float reach = largestOf3(constants + inverses * (largest + 1.0f));
        return (reach < 0x1p120f) & (scale > 0x1p-100f) & (scale < 0x1p100f);
    }
};

/// The space in which a ray runs along z, in float. Only rays that come to a leaf need it.
struct FastShear {
    Float4 origin, direction;  ///< in the order of the axes
    RayAxes axes;
    bool isReady;
    float shearX, shearY;
    float scaleZ;  ///< from z to distance

    RAYSCOPE_INLINE void prepareOnce(RayWords ray, float scale) {
        if (isReady) return;
        isReady = true;
        axes = RayAxes(ray);
        origin = axes.turned(ray);
        direction = axes.turned(ray + 3);
        shearX = direction[0] / direction[2];
        shearY = direction[1] / direction[2];
        scaleZ = scale / direction[2];
    }
};

}  // namespace rayscope::kernel
