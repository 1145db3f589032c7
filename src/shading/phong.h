#pragma once
#include <rayscope/vector.h>
#include <algorithm>
#include <cmath>

namespace rayscope::shading {

/// Parameters of Phong's reflection model.
struct PhongSurface {
    glm::dvec3 kd, ks;
    double shininess;
};

/// d reflected at the plane with unit normal n.
inline glm::dvec3 mirror(const glm::dvec3& d, const glm::dvec3& n) { return d - 2.0 * glm::dot(d, n) * n; }

/// Phong 1975: kd (N·L) + ks (R·V)^shininess, zero for light below the surface. All vectors have unit length
/// and point away from the surface. A shininess of 0 makes the highlight constant: 0^0 = 1.
inline glm::dvec3 phong(const PhongSurface& surface, const glm::dvec3& n, const glm::dvec3& l,
                        const glm::dvec3& v) {
    const double cosine = glm::dot(n, l);
    if (!(cosine > 0.0)) return glm::dvec3(0.0);
    glm::dvec3 reflected = surface.kd * cosine;
    if (surface.ks != glm::dvec3(0.0)) {
        const double along = std::max(0.0, glm::dot(mirror(-l, n), v));
        reflected += surface.ks * std::pow(along, surface.shininess);
    }
    return reflected;
}

}  // namespace rayscope::shading
