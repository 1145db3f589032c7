#pragma once
// Error bounds of hits.
#include "bvh/intersect/intersect_sphere.h"
#include "bvh/intersect/intersect_triangle.h"

namespace rayscope::bvh {

/// Bounds of the absolute error of what intersectTriangle() computes in double, for a ray and a triangle of
/// finite floats whose differences do not leave the range of double.
///
/// With ε = 2^-53, m the largest absolute coordinate of a corner relative to the origin, and X the largest
/// sheared coordinate plus 2^-50 m: a shear slope has a relative error of ε, so a sheared coordinate has an
/// error of at most mε + 3mε + 2mε < 2^-50 m. An edge function of two of them, whose own rounding is at most
/// 1.5 · 2^-52 of its value, is off by at most 4 · 2^-50 mX + 1.5 · 2^-52 · 2X² < 6 · 2^-50 mX (`edge`,
/// because X ≤ 2m + 2^-50 m). The determinant is off by three of those. As long as that is less than a
/// quarter of it, a weight is off by at most 4 · 4/3 edge errors over the determinant and a few roundings,
/// and t, the mean of depths of at most m with these weights, by m times 6 · 4/3. Slivers that are nearly
/// edge-on have a smaller determinant; the only bounds for them are weights in [0, 1] and a depth between
/// those of the corners.
struct HitError {
    double edge = 0.0;    ///< of an edge function of sheared corners
    double t = 0.0;       ///< in units of the ray's direction
    double weight = 0.0;  ///< of u and v

    HitError(const ShearedRay& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

    /// The bounds of the floats in a Hit: rounding adds half a unit in the last place.
    double ofHitT(double exactT) const;
    double ofHitWeight(double exactWeight) const;
};

/// A bound of the absolute error of both roots of intersectSphere() in units of the ray's direction d.
///
/// With D the distance of the origin from the center, r the radius, and Δ = r² − p² with p the distance of
/// the line from the center: p is off by less than 4εD across the line, so Δ by less than 8εrD + 4εr², its
/// root by that over 2√Δ, and b by 4εD|d|. The far root adds those; the near root is c/q, whose numerator is
/// off by 4εD(D + r) and whose denominator is at least √Δ|d|, and at least 0.8 D|d| beyond two radii.
/// Together less than 2^-49 (D + r)(1 + r/√Δ)/|d|. Infinite for lines that graze the sphere within the error
/// of Δ.
double sphereHitError(const Ray& ray, const Sphere& sphere);

}  // namespace rayscope::bvh
