#pragma once
#include <rayscope/vector.h>
#include <cstdint>
#include <limits>

namespace rayscope {

/// The points origin + t * direction with tMin < t <= tMax.
/// The direction need not have unit length; t is in units of its length. A negative tMin counts as 0.
struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f, 0.0f, 1.0f};
    float tMin = 0.0f;
    float tMax = std::numeric_limits<float>::infinity();
};

/// Center and radius in scene units.
struct Sphere {
    glm::vec3 center{0.0f};
    float radius = 1.0f;
};

/// The primitive of a miss.
inline constexpr std::uint32_t kNoPrimitive = 0xffffffffu;

/// The result of a ray query; the default is a miss. `u` and `v` are the barycentric weights of the
/// triangle's second and third vertex; both are 0 for a sphere.
struct Hit {
    float t = std::numeric_limits<float>::infinity();
    std::uint32_t primitive = kNoPrimitive;  ///< triangles count first, then spheres
    float u = 0.0f;
    float v = 0.0f;
};

}  // namespace rayscope
