#pragma once
#include <rayscope/ray.h>

#include "bvh/kernel/hit_acceptance.h"

namespace rayscope::bvh {

/// A ray as the eight floats of the kernels.
inline kernel::RayData rayData(const Ray& ray) {
    static_assert(sizeof(Ray) == 8 * sizeof(float));
    return reinterpret_cast<const float*>(&ray);
}

/// A sphere as its center and radius.
inline const float* sphereData(const Sphere& sphere) {
    static_assert(sizeof(Sphere) == 4 * sizeof(float));
    return reinterpret_cast<const float*>(&sphere);
}

/// Hits in the layout of the kernels.
inline kernel::HitData* hitData(Hit* hit) {
    static_assert(sizeof(Hit) == sizeof(kernel::HitData));
    return reinterpret_cast<kernel::HitData*>(hit);
}

}  // namespace rayscope::bvh
