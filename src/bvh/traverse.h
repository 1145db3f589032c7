#pragma once
// How a ray walks the binary tree, and the brute-force twin that needs no tree.
#include <rayscope/accel.h>

#include "bvh/binary_tree.h"
#include "bvh/traversal_observer.h"

namespace rayscope {

/// The walk of Accel::closestHit over the binary tree, watched. Same hit, bit for bit.
template <TraversalObserver O>
bool closestHit(const BinaryTree& tree, const AccelInput& input, const Ray& ray, Hit& hit, O& observer);

/// Tests every primitive. Same answers as Accel, bit for bit.
bool closestHitBruteForce(const AccelInput& input, const Ray& ray, Hit& hit);
bool anyHitBruteForce(const AccelInput& input, const Ray& ray);

}  // namespace rayscope
