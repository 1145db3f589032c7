#include "viewer/model/camera_controller.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/vectors.h"

namespace rayscope::viewer {
namespace {

CameraDescription someCamera() {
    CameraDescription camera;
    camera.lookFrom = {2.0f, 1.5f, 3.0f};
    camera.lookAt = {0.2f, 0.1f, -0.3f};
    camera.fov = 40.0f;
    return camera;
}

double distanceOf(const CameraDescription& camera) { return math::distance(camera.lookFrom, camera.lookAt); }

TEST(CameraController, orbitKeepsTargetAndDistance) {
    CameraDescription camera = someCamera();
    orbit(camera, {37.0, -21.0});
    EXPECT_EQ(camera.lookAt, someCamera().lookAt);
    EXPECT_NEAR(distanceOf(camera), distanceOf(someCamera()), 1e-5f);
    EXPECT_GT(glm::distance(camera.lookFrom, someCamera().lookFrom), 0.1f);
}

TEST(CameraController, orbitMovesTheSceneWithTheCursor) {
    CameraDescription camera = someCamera();
    const ViewFrame before = viewFrame(camera, 400, 400);
    // A point between camera and target moves with the cursor.
    const glm::dvec3 point = glm::mix(before.eye, glm::dvec3(camera.lookAt), 0.8);
    orbit(camera, {20.0, 10.0});
    const glm::dvec2 projected = *viewFrame(camera, 400, 400).project(point);
    EXPECT_GT(projected.x, 200.0);
    EXPECT_GT(projected.y, 200.0);
}

TEST(CameraController, orbitStopsBeforeThePoles) {
    for (const double direction : {1.0, -1.0}) {
        CameraDescription camera = someCamera();
        for (int i = 0; i < 100; ++i) orbit(camera, {3.0, 50.0 * direction});
        const glm::vec3 arm = glm::normalize(camera.lookFrom - camera.lookAt);
        EXPECT_LT(std::abs(glm::dot(arm, camera.up)), 1.0f);
        // Dragging back leaves the pole.
        for (int i = 0; i < 4; ++i) orbit(camera, {0.0, -50.0 * direction});
        EXPECT_LT(std::abs(glm::dot(glm::normalize(camera.lookFrom - camera.lookAt), camera.up)), 0.9f);
    }
}

TEST(CameraController, panMovesTheTargetPlaneWithTheCursor) {
    CameraDescription camera = someCamera();
    const glm::dvec3 target(camera.lookAt);
    pan(camera, {31.0, -12.0}, 480);
    const glm::dvec2 projected = *viewFrame(camera, 640, 480).project(target);
    EXPECT_NEAR(projected.x, 320.0 + 31.0, 1e-3);
    EXPECT_NEAR(projected.y, 240.0 - 12.0, 1e-3);
}

TEST(CameraController, zoomKeepsTheAnchorUnderTheCursor) {
    CameraDescription camera = someCamera();
    const glm::dvec2 cursor(500.0, 90.0);
    const ViewFrame before = viewFrame(camera, 640, 480);
    const glm::dvec3 anchor = before.eye + 2.5 * before.directionThrough(cursor);
    for (int i = 0; i < 10; ++i) zoomToward(camera, anchor, 0.88);
    const ViewFrame after = viewFrame(camera, 640, 480);
    EXPECT_LT(glm::distance(*after.project(anchor), cursor), 0.01);
    EXPECT_NEAR(glm::distance(after.eye, anchor), 2.5 * std::pow(0.88, 10), 1e-5);
    EXPECT_LT(glm::distance(after.forward, before.forward), 1e-5);
}

TEST(CameraController, zoomStopsAtTheResolutionOfFloat) {
    CameraDescription camera = someCamera();
    const glm::dvec3 anchor(camera.lookAt);
    for (int i = 0; i < 2000; ++i) zoomToward(camera, anchor, 0.5);
    EXPECT_GT(distanceOf(camera), 0.0);
    for (int i = 0; i < 4000; ++i) zoomToward(camera, anchor, 2.0);
    EXPECT_GT(distanceOf(camera), 1e36);
    EXPECT_TRUE(math::isFinite(camera.lookFrom));
    EXPECT_GT(glm::length(viewFrame(camera, 4, 4).forward), 0.99);
}

TEST(CameraController, pointAtFocusDepthLiesUnderTheCursorInTheTargetPlane) {
    const CameraDescription camera = someCamera();
    const ViewFrame frame = viewFrame(camera, 640, 480);
    const glm::dvec3 point = pointAtFocusDepth(camera, frame, {11.0, 470.0});
    EXPECT_LT(glm::distance(*frame.project(point), glm::dvec2(11.0, 470.0)), 1e-9);
    EXPECT_NEAR(glm::dot(point - glm::dvec3(camera.lookAt), frame.forward), 0.0, 1e-12);
}

TEST(CameraController, lookTurnsInPlace) {
    CameraDescription camera = someCamera();
    look(camera, {25.0, 0.0});
    EXPECT_EQ(camera.lookFrom, someCamera().lookFrom);
    EXPECT_NEAR(distanceOf(camera), distanceOf(someCamera()), 1e-5f);
    // The view turns with the mouse, as in games: the former centre is on the left now.
    EXPECT_LT(viewFrame(camera, 400, 400).project(glm::dvec3(someCamera().lookAt))->x, 200.0);
    camera = someCamera();
    look(camera, {0.0, 25.0});
    EXPECT_LT(viewFrame(camera, 400, 400).project(glm::dvec3(someCamera().lookAt))->y, 200.0);
}

TEST(CameraController, walkMovesAlongTheView) {
    CameraDescription camera = someCamera();
    const ViewFrame frame = viewFrame(camera, 4, 4);
    walk(camera, {0.0, 0.0, 0.5});
    EXPECT_LT(glm::distance(glm::dvec3(camera.lookFrom), frame.eye + 0.5 * frame.forward), 1e-6);
    EXPECT_NEAR(distanceOf(camera), distanceOf(someCamera()), 1e-5f);
}

TEST(CameraController, frameAllFitsEveryCornerIntoThePicture) {
    const SceneBounds bounds{{-3.0f, 0.0f, 10.0f}, {5.0f, 1.0f, 40.0f}};
    for (const double aspect : {0.4, 1.0, 2.5}) {
        CameraDescription camera = someCamera();
        const ViewFrame before = viewFrame(camera, 4, 4);
        frameAll(camera, bounds, aspect);
        const ViewFrame frame = viewFrame(camera, static_cast<int>(400 * aspect), 400);
        EXPECT_LT(glm::distance(frame.forward, before.forward), 1e-5);
        for (int corner = 0; corner < 8; ++corner) {
            const auto projected = frame.project(
                glm::dvec3(corner & 1 ? 5.0 : -3.0, corner & 2 ? 1.0 : 0.0, corner & 4 ? 40.0 : 10.0));
            ASSERT_TRUE(projected);
            EXPECT_TRUE(projected->x >= 0.0 && projected->x <= frame.width && projected->y >= 0.0 &&
                        projected->y <= frame.height);
        }
    }
}

TEST(CameraController, viewAlongLooksFromTheAxis) {
    CameraDescription camera = someCamera();
    viewAlong(camera, {1.0, 0.0, 0.0});
    EXPECT_LT(glm::distance(glm::normalize(camera.lookFrom - camera.lookAt), glm::vec3(1.0f, 0.0f, 0.0f)),
              1e-6f);
    EXPECT_NEAR(distanceOf(camera), distanceOf(someCamera()), 1e-5f);
    // From above the direction stays slightly off the up vector, so that the roll is defined.
    viewAlong(camera, {0.0, 1.0, 0.0});
    const glm::vec3 from = glm::normalize(camera.lookFrom - camera.lookAt);
    EXPECT_GT(from.y, 0.999f);
    EXPECT_LT(from.y, 1.0f);
}

}  // namespace
}  // namespace rayscope::viewer
