// The edge of a half-plane's shadow, hard under a point light.
#include <random>

#include "support/closed_forms.h"
#include "support/statistics.h"
#include "support/tracing.h"
#include "trace/shadow_ray.h"

namespace rayscope::test {
namespace {

constexpr int kRowWidth = 64;

/// A floor seen from straight above, and an occluding half-plane x < 0 at a quarter of the light's height.
struct HalfPlane {
    SceneDescription scene;
    double edge;  ///< x of the shadow's edge on the floor, which is lit beyond it
};
HalfPlane halfPlaneScene(const glm::vec3& light) {
    HalfPlane made;
    made.scene.materials = {material(Rgb(0.5f))};
    made.scene.meshes = {quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}),
                         quad({-9, light.y / 4, 9}, {9, 0, 0}, {0, 0, -18})};
    made.scene.lights = {pointLight(light)};
    made.edge = -static_cast<double>(light.x) / 3.0;  // similar triangles over the edge at x = 0
    // Below the half-plane, so that it does not hide the floor.
    CameraDescription camera;
    camera.lookFrom = {0, light.y / 5, 0};
    camera.lookAt = {0, 0, 0};
    camera.up = {0, 0, -1};
    camera.fov = 3.4f;  // of the height; the row is 64 times as wide and shows x = −1.5 … 1.5
    made.scene.cameras = {camera};
    return made;
}

/// Column of the shadow's edge, as the sum of the row's brightness relative to the lit side.
double edgeColumn(const trace::World& world, const trace::World& lit) {
    double shadowed = 0.0;
    for (int x = 0; x < kRowWidth; ++x) {
        const double full = pixelMean(lit, 1, x, 0, 1024).x;
        shadowed += 1.0 - pixelMean(world, 1, x, 0, 1024).x / full;
    }
    return shadowed;
}

TEST(HardShadow, HasItsEdgeAtTheProjectionOfTheOccluder) {
    for (const bool shading : {true, false}) {
        double worst = 0.0;
        for (const float lightX : {-1.0f, 0.0f, 0.7f, 1.3f}) {
            const HalfPlane made = halfPlaneScene({lightX, 4.0f, 0.0f});
            Settings settings;
            settings.shading = shading;
            const auto world = compileScene(made.scene, settings, kRowWidth, 1);
            settings.hardShadows = false;
            const auto lit = compileScene(made.scene, settings, kRowWidth, 1);
            const double expected = world->camera.project({made.edge, 0.0, 0.0}).x;
            updateWorst(worst, std::abs(edgeColumn(*world, *lit) - expected));
        }
        EXPECT_LT(worst, 0.01);
        reportDeviation(
            shading ? "hard shadow, edge position" : "hard shadow with shading off, edge position", worst,
            "pixels");
    }
}

TEST(HardShadow, ClassifiesEverySampleOfTheFloor) {
    const HalfPlane made = halfPlaneScene({0.7f, 4.0f, 0.0f});
    const auto world = compileScene(made.scene, {}, kRowWidth, 1);
    RecordingObserver record;
    for (int x = 0; x < kRowWidth; ++x) pixelMean(*world, 1, x, 0, kRowWidth, record);
    ASSERT_EQ(record.lights.size(), std::size_t{kRowWidth * kRowWidth});
    double closest = 1.0;
    for (std::size_t i = 0; i < record.lights.size(); ++i) {
        const double beyond = record.hits[i].position.x - made.edge;
        const bool visible = record.lights[i].visibility == Visibility::Visible;
        EXPECT_TRUE(visible == (beyond > 0.0) || std::abs(beyond) < 1e-6) << beyond;
        closest = std::min(closest, std::abs(beyond));
    }
    EXPECT_LT(closest, 1e-3);  // some samples are close enough to the edge to be a test
}

TEST(HardShadow, IgnoresTheSurfaceItselfAndTheLamp) {
    SceneDescription scene;
    scene.materials = {material(Rgb(1.0f))};
    scene.meshes = {quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -18}), quad({-9, 3, 9}, {18, 0, 0}, {0, 0, -18})};
    scene.lights = {pointLight({0, 3, 0})};  // exactly in the upper plane
    scene.cameras = {pointCamera({1, 2, 1}, glm::vec3(0.5f, 0, 0))};
    EventCounter counter;
    pixelMean(*compileScene(scene, {}, 1, 1), 0, 0, 0, 1, counter);
    EXPECT_EQ(counter.lights[static_cast<int>(Visibility::Visible)], 1);
}

/// See the derivation in trace/shadow_ray.h. Lamps are parallelograms in general position whose vertices are
/// rounded to float.
TEST(ShadowRay, EndsBeforeTheSurfaceOfTheLamp) {
    std::mt19937_64 random(5);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto vector = [&](double size) {
        return glm::dvec3(uniform(-size, size), uniform(-size, size), uniform(-size, size));
    };
    int occluded = 0, occludedBeyond = 0;
    for (int lamp = 0; lamp < 300; ++lamp) {
        const glm::vec3 corner(vector(lamp % 3 == 0 ? 1.0 : 30.0)), a(vector(1.0)), b(vector(1.0));
        SceneDescription scene;
        scene.materials = {material(Rgb(1.0f))};
        scene.meshes = {quad(corner, a, b)};
        scene.cameras = {pointCamera({0, 0, 3}, glm::vec3(0))};
        const auto world = compileScene(scene, {}, 1, 1);
        const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(a), glm::dvec3(b)));
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 light = glm::dvec3(corner) + uniform(0.05, 0.95) * glm::dvec3(a) +
                                     uniform(0.05, 0.95) * glm::dvec3(b);
            const double angle = uniform(0.0, std::numbers::pi / 3.0);
            const glm::dvec3 side = glm::normalize(glm::cross(normal, vector(1.0)));
            const glm::dvec3 direction = std::cos(angle) * normal + std::sin(angle) * side;
            const glm::vec3 from(light + std::pow(10.0, uniform(-1.0, 1.0)) * direction);
            Ray ray = trace::shadowRay(from, light);
            occluded += world->anyHit(ray, 0.0f) ? 1 : 0;
            ray.tMax = 1.0f + 0x1p-16f;
            occludedBeyond += world->anyHit(ray, 0.0f) ? 1 : 0;
        }
    }
    EXPECT_EQ(occluded, 0);
    EXPECT_GT(occludedBeyond, 300 * 200 * 9 / 10);  // the rays do reach the lamp
}

}  // namespace
}  // namespace rayscope::test
