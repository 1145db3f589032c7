#include "bench/bench_scene.h"

#include <cmath>
#include <numbers>
#include <random>

namespace rayscope::bench {
namespace {

constexpr int kTile = 8;

glm::vec3 bumpyPoint(double theta, double phi) {
    const double bump = 0.1 * std::sin(5 * phi) * std::sin(7 * theta) +
                        0.02 * std::sin(41 * phi + 13 * theta) + 0.004 * std::cos(173 * theta - 97 * phi);
    const double r = 1.0 + bump * std::sin(theta);
    return {r * std::sin(theta) * std::cos(phi), r * std::cos(theta), r * std::sin(theta) * std::sin(phi)};
}

std::vector<Ray> primaryRays(int resolution) {
    std::vector<Ray> rays;
    for (int tileY = 0; tileY < resolution; tileY += kTile)
        for (int tileX = 0; tileX < resolution; tileX += kTile)
            for (int y = tileY; y < tileY + kTile; ++y)
                for (int x = tileX; x < tileX + kTile; ++x) {
                    const double px = (x + 0.5) / resolution - 0.5, py = (y + 0.5) / resolution - 0.5;
                    rays.push_back({{0.3f, 0.7f, 3.0f}, glm::normalize(glm::vec3(px, py - 0.23, -1.1))});
                }
    return rays;
}

Ray secondaryRay(RayKind kind, const glm::vec3& point, const glm::vec3& normal, std::mt19937& random) {
    if (kind == RayKind::Shadow) return {point, glm::vec3(2, 4, 1) - point, 0.0f, 1.0f};
    std::uniform_real_distribution<float> uniform(-1, 1);
    glm::vec3 inBall;
    do inBall = {uniform(random), uniform(random), uniform(random)};
    while (glm::dot(inBall, inBall) > 1.0f || glm::dot(inBall, inBall) < 1e-4f);
    const glm::vec3 direction =
        glm::normalize(normal + 0.999f * glm::normalize(inBall));  // cosine-distributed
    return {point, direction, 0.0f, kind == RayKind::Bounce ? std::numeric_limits<float>::infinity() : 0.3f};
}

}  // namespace

BumpySphere::BumpySphere(int triangleCount) {
    const int rings = std::max(3, static_cast<int>(std::lround(std::sqrt(triangleCount / 4.0)))),
              segments = 2 * rings;
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j <= segments; ++j)
            vertices.push_back(bumpyPoint(std::numbers::pi * i / rings, 2 * std::numbers::pi * j / segments));
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < segments; ++j) {
            const auto a = static_cast<unsigned>(i * (segments + 1) + j),
                       b = a + static_cast<unsigned>(segments) + 1;
            triangles.emplace_back(a, b, a + 1);
            triangles.emplace_back(a + 1, b, b + 1);
        }
}

const char* nameOf(RayKind kind) {
    switch (kind) {
        case RayKind::Primary:
            return "primary";
        case RayKind::Shadow:
            return "shadow";
        case RayKind::Bounce:
            return "bounce";
        case RayKind::AmbientOcclusion:
            return "ao";
    }
    return "";
}

std::vector<Ray> makeRays(const Accel& accel, RayKind kind, int resolution) {
    const std::vector<Ray> primary = primaryRays(resolution);
    if (kind == RayKind::Primary) return primary;
    std::mt19937 random(1);
    std::vector<Ray> rays;
    const AccelInput& input = accel.input();
    for (const Ray& ray : primary) {
        Hit hit;
        if (!accel.closestHit(ray, hit)) continue;
        const glm::uvec3& t = input.triangles[hit.primitive];
        const glm::dvec3 a = input.vertices[t.x], b = input.vertices[t.y], c = input.vertices[t.z];
        glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
        if (glm::dot(normal, glm::dvec3(ray.direction)) > 0.0) normal = -normal;
        const glm::dvec3 point =
            glm::dvec3(ray.origin) + double(hit.t) * glm::dvec3(ray.direction) + 1e-5 * normal;
        rays.push_back(secondaryRay(kind, glm::vec3(point), glm::vec3(normal), random));
    }
    return rays;
}

}  // namespace rayscope::bench
