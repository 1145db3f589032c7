#pragma once
// Ray-sphere intersection in double with a discriminant that does not cancel.
#include <rayscope/ray.h>

namespace rayscope::bvh {

/// Both intersections of the whole line with the sphere, near <= far, in units of the direction. Returns
/// false without one, for radii that are not > 0, and for coordinates that are not finite. The absolute error
/// is at most a few 2^-53 · (|origin − center| + radius) / |direction|, except near the silhouette, where the
/// square root of that error enters (Haines, Günther, Akenine-Möller 2019, in double).
bool intersectSphere(const Ray& ray, const Sphere& sphere, double& near, double& far);

/// The first root whose float value lies in (tMin, tMax].
bool intersectSphere(const Ray& ray, const Sphere& sphere, float tMin, float tMax, double& t);

}  // namespace rayscope::bvh
