#pragma once
// Ray-sphere intersection in double with a discriminant that does not cancel.
#include <rayscope/ray.h>

namespace rayscope {

/// The first root whose float value lies in (tMin, tMax]. Returns false without one, and for radii that are
/// not > 0.
bool intersectSphere(const Ray& ray, const Sphere& sphere, float tMin, float tMax, double& t);

}  // namespace rayscope
