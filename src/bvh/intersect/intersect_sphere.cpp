#include "bvh/intersect/intersect_sphere.h"

#include <initializer_list>
#include "bvh/intersect/ray_data.h"
#include "bvh/kernel/sphere.h"

namespace rayscope::bvh {

bool intersectSphere(const Ray& ray, const Sphere& sphere, double& near, double& far) {
    return kernel::intersectSphere(rayData(ray), sphereData(sphere), near, far);
}

bool intersectSphere(const Ray& ray, const Sphere& sphere, float tMin, float tMax, double& t) {
    double near, far;
    if (!intersectSphere(ray, sphere, near, far)) return false;
    for (const double root : {near, far}) {
        const float rounded = static_cast<float>(root);
        if (rounded > tMin && rounded <= tMax) {
            t = root;
            return true;
        }
    }
    return false;
}

}  // namespace rayscope::bvh
