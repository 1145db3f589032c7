#include "bvh/intersect/hit_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rayscope::bvh {

namespace {

double largestOf(const kernel::ShearedVertex& v) { return std::max(std::abs(v.x), std::abs(v.y)); }

/// Half a unit in the last place of a float near x, which has that error already.
double halfUlp(double x, double error) { return 0x1p-24 * (std::abs(x) + error) + 0x1p-150; }

}  // namespace

HitError::HitError(const ShearedRay& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    constexpr double kEpsilon = 0x1p-53;
    double m = 0.0;
    for (const glm::vec3* v : {&a, &b, &c})
        for (int axis = 0; axis < 3; ++axis)
            m = std::max(m, std::abs(static_cast<double>((*v)[axis]) - ray.origin[axis]));
    const kernel::ShearedVertex sa = shear(ray, &a.x), sb = shear(ray, &b.x), sc = shear(ray, &c.x);
    const double extent = std::max({largestOf(sa), largestOf(sb), largestOf(sc)}) + 0x1p-50 * m;
    edge = 6.0 * 0x1p-50 * m * extent;

    const double det = std::abs(kernel::differenceOfProducts(sc.x, sb.y, sc.y, sb.x) +
                                kernel::differenceOfProducts(sa.x, sc.y, sa.y, sc.x) +
                                kernel::differenceOfProducts(sb.x, sa.y, sb.y, sa.x));
    const double depth = m * std::abs(ray.scaleZ);
    if (3.0 * edge < 0.25 * det) {
        weight = std::min(1.0, 6.0 * edge / det + 8.0 * kEpsilon);
        t = std::min(2.0 * depth, depth * (8.0 * edge / det + 16.0 * kEpsilon));
    } else {
        weight = 1.0;
        t = 2.0 * depth;
    }
}

double HitError::ofHitT(double exactT) const { return t + halfUlp(exactT, t); }
double HitError::ofHitWeight(double exactWeight) const { return weight + halfUlp(exactWeight, weight); }

double sphereHitError(const Ray& ray, const Sphere& sphere) {
    const glm::dvec3 direction = ray.direction;
    const glm::dvec3 fromCenter = glm::dvec3(ray.origin) - glm::dvec3(sphere.center);
    const double r = sphere.radius, reach = glm::length(fromCenter) + r, length = glm::length(direction);
    const glm::dvec3 closest = fromCenter - glm::dot(fromCenter, direction) / (length * length) * direction;
    const double discriminant = r * r - glm::dot(closest, closest);
    if (!(discriminant > 0x1p-48 * r * reach)) return std::numeric_limits<double>::infinity();
    return 0x1p-49 * reach * (1.0 + r / std::sqrt(discriminant)) / length;
}

}  // namespace rayscope::bvh
