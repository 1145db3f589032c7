#pragma once
// Ray-sphere intersection, compiled once for all instruction sets. A sphere is {center, radius}.
#include "bvh/kernel/hit_acceptance.h"

namespace rayscope::bvh::kernel {

/// Both intersections of the whole line with the sphere, in double with a discriminant that does not cancel;
/// see intersect/intersect_sphere.h.
bool intersectSphere(RayData ray, const float* sphere, double& near, double& far);

/// The box of a sphere in the layout of BoxPlanes, rounded outward because center ± radius is not a float in
/// general.
void sphereBox(const float* sphere, float (&planes)[8]);

/// The intersections of the ray with a sphere up to `bound`, with t, u and v. Returns how many there are: the
/// ray enters and leaves the sphere, or one of the two lies outside (tMin, bound].
int crossSphere(RayData ray, const float* sphere, float bound, HitData (&found)[2]);

/// Tests one sphere up to `bound`; on success `found` has t, u and v.
bool hitsSphere(RayData ray, const float* sphere, float bound, HitData& found);

}  // namespace rayscope::bvh::kernel
