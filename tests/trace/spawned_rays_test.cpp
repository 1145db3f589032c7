// Rays spawned on spheres: outward they miss, inward they hit the far side. Triangles are tested by
// `rayscope lab`; see tests/measure.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "math/frame.h"
#include "support/tracing.h"
#include "trace/interaction.h"

namespace rayscope::test {
namespace {

class SphereRays {
  public:
    SphereRays(double radius, const glm::dvec3& center, std::uint64_t seed)
        : random_(seed), radius_(static_cast<float>(radius)) {
        SceneDescription scene;
        scene.materials = {material(Rgb(1.0f))};
        scene.spheres = {{"s", {glm::vec3(center), static_cast<float>(radius)}, 0, glm::vec3(0)}};
        scene.cameras = {pointCamera({0, 0, 3}, glm::vec3(0))};
        world_ = compileScene(scene, {}, 1, 1);
        center_ = glm::dvec3(scene.spheres[0].sphere.center);
    }

    /// Shoots a ray from `distance` radii above the surface and checks the rays spawned at its hit.
    void traceSpawnedRay(double distance) {
        Ray first;
        const glm::dvec3 outward = onSphere();
        first.origin = glm::vec3(center_ + radius_ * (1.0 + distance) * outward);
        const glm::dvec3 target = center_ + radius_ * std::pow(real(), 0.25) * onSphere();
        first.direction = glm::vec3(target - glm::dvec3(first.origin));
        Hit hit;
        if (first.direction == glm::vec3(0.0f) || !world_->closestHit(first, 0.0f, hit)) return;
        const trace::Interaction at = trace::interactionAt(*world_, first, 0.0f, {}, hit);
        const double off = glm::length(at.position - center_) / radius_ - 1.0;
        ASSERT_LE(std::abs(off), 0x1p-48 * (1.0 + glm::length(center_) / radius_));
        const bool inside = glm::dot(at.geometricNormal, at.position - center_) < 0.0;
        for (const bool through : {false, true}) {
            const glm::dvec3 normal = through ? -at.geometricNormal : at.geometricNormal;
            const double sine = std::pow(10.0, -4.0 * real());
            const bool inward = through != inside;
            if (inward && sine < 0.05) continue;  // a chord as short as the offset
            const math::Frame frame = math::frameAround(normal);
            const double phi = 6.283185307179586 * real(), cosine = std::sqrt(1.0 - sine * sine);
            const Ray next{
                through ? at.originBehind() : at.originOutside(),
                glm::vec3(sine * normal + cosine * (std::cos(phi) * frame.u + std::sin(phi) * frame.v))};
            ASSERT_EQ(world_->closestHit(next, 0.0f, hit), inward)
                << "radius " << radius_ << ", distance " << distance << ", sine " << sine;
            if (inward) {
                ASSERT_NEAR(static_cast<double>(hit.t), 2.0 * radius_ * sine, 1e-2 * radius_);
            }
            ++left;
        }
    }

    int left = 0;

  private:
    double real() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
    glm::dvec3 onSphere() {
        const double z = 2.0 * real() - 1.0, phi = 6.283185307179586 * real(), r = std::sqrt(1.0 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }

    std::mt19937_64 random_;
    double radius_;
    glm::dvec3 center_{0.0};
    std::shared_ptr<const trace::World> world_;
};

TEST(SpawnedRays, OnSpheresOfAnySizeAreCorrect) {
    int left = 0;
    for (const double radius : {1e-6, 1e-3, 1.0, 1e3, 1e6})
        for (const double offset : {0.0, 1.0, 1e3}) {
            SphereRays sphere(radius, radius * offset * glm::dvec3(0.6, -0.8, 0.3), 11);
            for (const double distance : {-0.5, 1e-3, 1.0, 1e3, 1e5, 1e7})
                for (int i = 0; i < 3000; ++i) ASSERT_NO_FATAL_FAILURE(sphere.traceSpawnedRay(distance));
            left += sphere.left;
        }
    EXPECT_GT(left, 200000);
}

}  // namespace
}  // namespace rayscope::test
