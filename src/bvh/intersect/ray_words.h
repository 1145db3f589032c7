#pragma once
#include <rayscope/ray.h>

#include "bvh/kernel/query.h"

namespace rayscope::bvh {

/// A ray as the eight numbers that kernels take.
inline kernel::RayWords words(const Ray& ray) {
    static_assert(sizeof(Ray) == 8 * sizeof(float));
    return reinterpret_cast<const float*>(&ray);
}

/// Hits as kernels fill them in.
inline kernel::HitWords* hitWords(Hit* hit) {
    static_assert(sizeof(Hit) == sizeof(kernel::HitWords));
    return reinterpret_cast<kernel::HitWords*>(hit);
}

}  // namespace rayscope::bvh
