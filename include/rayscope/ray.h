#pragma once
#include <rayscope/vector.h>
#include <cstdint>
#include <limits>

namespace rayscope {

/// A half-line: the points origin + t * direction with tMin < t <= tMax.
/// The direction need not be of unit length; t is in its units. A negative tMin counts as 0.
struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f, 0.0f, 1.0f};
    float tMin = 0.0f;
    float tMax = std::numeric_limits<float>::infinity();
};

struct Sphere {
    glm::vec3 center{0.0f};
    float radius = 1.0f;
};

inline constexpr std::uint32_t kNoPrimitive = 0xffffffffu;

/// The answer to a ray query. Triangles count first, then spheres. `u` and `v` are the barycentric weights of
/// the triangle's second and third vertex; both are 0 for a sphere.
struct Hit {
    float t = std::numeric_limits<float>::infinity();
    std::uint32_t primitive = kNoPrimitive;
    float u = 0.0f;
    float v = 0.0f;
};

}  // namespace rayscope
