#pragma once
#include <rayscope/ray.h>

#include "bvh/kernel/ray_setup.h"

namespace rayscope {

/// A ray as the eight numbers that kernels take.
inline kernel::RayWords words(const Ray& ray) {
    static_assert(sizeof(Ray) == 8 * sizeof(float));
    return reinterpret_cast<const float*>(&ray);
}

}  // namespace rayscope
