#include "viewer/model/projection.h"

#include <gtest/gtest.h>

#include <random>

#include "trace/camera.h"

namespace rayscope::viewer {
namespace {

std::vector<CameraDescription> someCameras() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> coordinate(-5.0f, 5.0f), angle(10.0f, 120.0f);
    std::vector<CameraDescription> cameras;
    for (int i = 0; i < 50; ++i) {
        CameraDescription camera;
        camera.lookFrom = {coordinate(random), coordinate(random), coordinate(random)};
        camera.lookAt = {coordinate(random), coordinate(random), coordinate(random)};
        camera.up = {coordinate(random), coordinate(random), coordinate(random)};
        camera.fov = angle(random);
        cameras.push_back(camera);
    }
    CameraDescription alongUp;
    alongUp.lookFrom = {0.0f, 3.0f, 0.0f};
    cameras.push_back(alongUp);
    return cameras;
}

TEST(Projection, generatesTheRaysOfTheTracersCamera) {
    for (const CameraDescription& description : someCameras()) {
        const trace::Camera camera(description, 640, 360);
        const ViewFrame frame = viewFrame(description, 640, 360);
        for (const glm::dvec2 pixel :
             {glm::dvec2(0.5, 0.5), glm::dvec2(320, 180), glm::dvec2(600.25, 17.5)}) {
            const glm::dvec3 wanted(camera.pinholeRay(pixel).direction);
            // The tracer rounds its directions to float.
            EXPECT_LT(glm::distance(frame.directionThrough(pixel), wanted), 1.2e-7);
        }
    }
}

TEST(Projection, projectInvertsDirectionThrough) {
    for (const CameraDescription& description : someCameras()) {
        const trace::Camera camera(description, 300, 500);
        const ViewFrame frame = viewFrame(description, 300, 500);
        const glm::dvec2 pixel(123.25, 77.75);
        const glm::dvec3 point = frame.eye + 3.7 * frame.directionThrough(pixel);
        const auto found = frame.project(point);
        ASSERT_TRUE(found);
        EXPECT_LT(glm::distance(*found, pixel), 1e-9);
        EXPECT_LT(glm::distance(camera.project(point), pixel), 1e-9);
    }
}

TEST(Projection, doesNotProjectPointsBehindTheCamera) {
    const ViewFrame frame = viewFrame(CameraDescription{}, 100, 100);
    EXPECT_FALSE(frame.project(frame.eye - frame.forward));
    EXPECT_FALSE(frame.project(frame.eye));
}

TEST(Projection, matrixAgreesWithProject) {
    const SceneBounds bounds{glm::vec3(-2.0f), glm::vec3(2.0f)};
    for (const CameraDescription& description : someCameras()) {
        const ViewFrame frame = viewFrame(description, 640, 360);
        const glm::dvec2 pixel(444.0, 111.0);
        const glm::dvec3 point = frame.eye + 4.0 * frame.directionThrough(pixel);
        const glm::vec4 clip = viewProjection(frame, bounds) * glm::vec4(glm::vec3(point), 1.0f);
        const glm::dvec2 seen((clip.x / clip.w * 0.5 + 0.5) * 640.0, (0.5 - clip.y / clip.w * 0.5) * 360.0);
        EXPECT_LT(glm::distance(seen, pixel), 0.01);
    }
}

TEST(Projection, depthRangeContainsTheScene) {
    const SceneBounds bounds{glm::vec3(-1.0f), glm::vec3(1.0f)};
    CameraDescription camera;
    camera.lookFrom = {4.0f, 3.0f, 5.0f};
    const glm::mat4 matrix = viewProjection(viewFrame(camera, 100, 100), bounds);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const glm::vec4 clip = matrix * glm::vec4(point, 1.0f);
        EXPECT_LT(std::abs(clip.z), clip.w);
    }
}

TEST(Projection, worksAtEveryScale) {
    CameraDescription camera;
    const auto seenAt = [&](double scale) {
        CameraDescription scaled = camera;
        scaled.lookFrom = glm::vec3(scale * glm::dvec3(1.0, 2.0, 3.0));
        scaled.lookAt = glm::vec3(scale * glm::dvec3(0.1, 0.2, 0.0));
        const auto half = static_cast<float>(scale);
        const glm::mat4 matrix =
            viewProjection(viewFrame(scaled, 100, 100), {glm::vec3(-half), glm::vec3(half)});
        const glm::vec4 clip = matrix * glm::vec4(glm::vec3(scale * glm::dvec3(0.5, -0.25, 0.75)), 1.0f);
        EXPECT_TRUE(std::isnormal(clip.w)) << scale;
        return glm::vec3(clip) / clip.w;
    };
    const glm::vec3 reference = seenAt(1.0);
    for (int k = -35; k <= 30; ++k)
        EXPECT_LT(glm::distance(seenAt(std::pow(10.0, k)), reference), 1e-5f) << k;
    EXPECT_LT(glm::distance(seenAt(1e-40), reference), 1e-3f);
    EXPECT_EQ(drawingUnit(3.0), 1.0);
    EXPECT_EQ(drawingUnit(0.0), 1.0);
    EXPECT_EQ(drawingUnit(0x1.8p100), 0x1p100);
}

}  // namespace
}  // namespace rayscope::viewer
