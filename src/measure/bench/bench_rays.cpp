#include "measure/bench/bench_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sampling/hash.h"
#include "trace/camera.h"

namespace rayscope::measure {
namespace {

constexpr int kTile = 8;
constexpr double kOffset = 1e-5, kOcclusionDistance = 0.1;  // in sizes of the scene

std::vector<Ray> primaryRays(const trace::Camera& camera, int size) {
    std::vector<Ray> rays;
    rays.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (int tileY = 0; tileY < size; tileY += kTile)
        for (int tileX = 0; tileX < size; tileX += kTile)
            for (int y = tileY; y < std::min(size, tileY + kTile); ++y)
                for (int x = tileX; x < std::min(size, tileX + kTile); ++x)
                    rays.push_back(camera.pinholeRay({x + 0.5, y + 0.5}));
    return rays;
}

double sizeOf(const AccelInput& input) {
    glm::vec3 lower(std::numeric_limits<float>::max()), upper(-std::numeric_limits<float>::max());
    for (const glm::vec3& v : input.vertices) {
        lower = glm::min(lower, v);
        upper = glm::max(upper, v);
    }
    for (const Sphere& sphere : input.spheres) {
        lower = glm::min(lower, sphere.center - sphere.radius);
        upper = glm::max(upper, sphere.center + sphere.radius);
    }
    return glm::length(glm::dvec3(upper) - glm::dvec3(lower));
}

/// The geometric normal on the side of the ray's origin.
glm::dvec3 normalAt(const AccelInput& input, const Ray& ray, const Hit& hit, const glm::dvec3& point) {
    glm::dvec3 normal;
    if (hit.primitive >= input.triangles.size()) {
        normal = point - glm::dvec3(input.spheres[hit.primitive - input.triangles.size()].center);
    } else {
        const glm::uvec3& corner = input.triangles[hit.primitive];
        const glm::dvec3 a = input.vertices[corner.x];
        normal =
            glm::cross(glm::dvec3(input.vertices[corner.y]) - a, glm::dvec3(input.vertices[corner.z]) - a);
    }
    normal = glm::normalize(normal);
    return glm::dot(normal, glm::dvec3(ray.direction)) > 0.0 ? -normal : normal;
}

/// The n-th of a fixed sequence of random numbers in [0, 1).
double uniform(std::uint64_t n) {
    return static_cast<double>(sampling::hashPair(0x62656e6368, n) >> 11) * 0x1p-53;
}

glm::dvec3 cosineDirection(const glm::dvec3& normal, double u, double v) {
    const double z = 1.0 - 2.0 * u, r = std::sqrt(std::max(0.0, 1.0 - z * z)),
                 phi = 2.0 * std::numbers::pi * v;
    return glm::normalize(normal + 0.999 * glm::dvec3(r * std::cos(phi), r * std::sin(phi), z));
}

}  // namespace

std::string_view benchNameOf(BenchRayKind kind) {
    constexpr std::string_view names[] = {"primary", "shadow", "bounce", "ao"};
    return names[static_cast<int>(kind)];
}

bool isAnyHitKind(BenchRayKind kind) {
    return kind == BenchRayKind::Shadow || kind == BenchRayKind::AmbientOcclusion;
}

std::vector<Ray> makeBenchRays(const Accel& accel, const CameraDescription& description,
                               const glm::vec3& light, BenchRayKind kind, int size) {
    std::vector<Ray> primary = primaryRays(trace::Camera(description, size, size), size);
    if (kind == BenchRayKind::Primary) return primary;
    const double sceneSize = sizeOf(accel.input());
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < primary.size(); ++i) {
        const Ray& ray = primary[i];
        Hit hit;
        if (!accel.closestHit(ray, hit)) continue;
        const glm::dvec3 point =
            glm::dvec3(ray.origin) + static_cast<double>(hit.t) * glm::dvec3(ray.direction);
        const glm::dvec3 normal = normalAt(accel.input(), ray, hit, point);
        const glm::vec3 origin(point + kOffset * sceneSize * normal);
        if (kind == BenchRayKind::Shadow) {
            rays.push_back({origin, light - origin, 0.0f, 1.0f});
            continue;
        }
        const glm::vec3 direction(cosineDirection(normal, uniform(2 * i), uniform(2 * i + 1)));
        rays.push_back({origin, direction, 0.0f,
                        kind == BenchRayKind::Bounce ? std::numeric_limits<float>::infinity()
                                                     : static_cast<float>(kOcclusionDistance * sceneSize)});
    }
    return rays;
}

}  // namespace rayscope::measure
