#include "bvh/intersect_box.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rayscope {
namespace {

static_assert(std::numeric_limits<float>::is_iec559, "conversions to float must overflow to infinity");

/// 2^k with 2^k <= x < 2^(k+1), for positive normal x.
double powerOfTwoBelow(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000u);
}

}  // namespace

BoxRay::BoxRay(const Ray& ray) {
    constexpr double kPad = 0x1p-21;  // 8u
    constexpr float kLargest = std::numeric_limits<float>::max();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const glm::dvec3 length = glm::abs(glm::dvec3(ray.direction));
    scale = powerOfTwoBelow(glm::max(length.x, glm::max(length.y, length.z)));
    tMin = distance(ray.tMin);
    tMax = distance(ray.tMax);
    for (int axis = 0; axis < 3; ++axis) {
        origin[axis] = ray.origin[axis];
        nearPlane[axis] = axis + (std::signbit(ray.direction[axis]) ? 4 : 0);
        if (ray.direction[axis] == 0.0f) {
            nearInverse[axis] = farInverse[axis] = std::copysign(kInfinity, ray.direction[axis]);
        } else {
            // A near distance must not become infinite because the reciprocal did; a far distance may.
            const double inverse = scale / ray.direction[axis];
            nearInverse[axis] = glm::clamp(static_cast<float>(inverse * (1.0 - kPad)), -kLargest, kLargest);
            farInverse[axis] = static_cast<float>(inverse * (1.0 + kPad));
        }
    }
}

}  // namespace rayscope
