#include "viewer/model/light_handles.h"

#include <gtest/gtest.h>

namespace rayscope::viewer {
namespace {

ViewFrame someFrame() {
    CameraDescription camera;
    camera.lookFrom = {3.0f, 2.0f, 4.0f};
    return viewFrame(camera, 640, 480);
}

const Light kSegment{SegmentLight{{glm::vec3(0, 0, 0), glm::vec3(2, 0, 0)}, {Rgb(1), Rgb(1)}}};
const Light kParallelogram{ParallelogramLight{glm::vec3(0), {glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)}, {}}};

TEST(LightHandles, theFirstHandleMovesTheWholeLight) {
    for (const Light& light : {Light{PointLight{glm::vec3(1, 2, 3), Rgb(1)}}, kSegment, kParallelogram}) {
        const auto before = handlePositions(light);
        const auto after = handlePositions(withHandleMoved(light, 0, before[0] + glm::vec3(0, 1, 0)));
        ASSERT_EQ(before.size(), after.size());
        for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after[i], before[i] + glm::vec3(0, 1, 0));
    }
}

TEST(LightHandles, theOtherHandlesMoveOnePoint) {
    for (const Light& light : {kSegment, kParallelogram}) {
        const auto before = handlePositions(light);
        for (std::size_t moved = 1; moved < before.size(); ++moved) {
            const glm::vec3 position(0.25f, 5.0f, 0.5f);
            const auto after = handlePositions(withHandleMoved(light, static_cast<int>(moved), position));
            for (std::size_t i = 1; i < before.size(); ++i)
                EXPECT_LT(glm::distance(after[i], i == moved ? position : before[i]), 1e-6f);
        }
    }
}

TEST(LightHandles, anAxisHasItsLengthOnTheScreenAtAnyDistance) {
    CameraDescription camera;
    camera.lookFrom = {0.0f, 0.0f, 5.0f};
    const HandleSize size;
    for (const float z : {0.0f, 2.0f, -40.0f}) {
        const ViewFrame frame = viewFrame(camera, 640, 480);
        const glm::dvec3 center(0.0, 0.0, z);
        const glm::dvec2 a = *frame.project(center),
                         b = *frame.project(axisEnd(frame, center, HandlePart::X, size));
        EXPECT_NEAR(glm::distance(a, b), size.axis, 1e-6);
    }
}

TEST(LightHandles, picksThePartUnderTheCursor) {
    const ViewFrame frame = someFrame();
    const HandleSize size;
    const glm::dvec3 center(0.1, 0.2, 0.3);
    EXPECT_EQ(pickHandlePart(frame, center, *frame.project(center), size), HandlePart::Free);
    for (const HandlePart handlePart : {HandlePart::X, HandlePart::Y, HandlePart::Z}) {
        const glm::dvec2 nearEnd =
            glm::mix(*frame.project(center), *frame.project(axisEnd(frame, center, handlePart, size)), 0.9);
        EXPECT_EQ(pickHandlePart(frame, center, nearEnd, size), handlePart);
    }
    EXPECT_FALSE(pickHandlePart(frame, center, *frame.project(center) + glm::dvec2(200.0, 0.0), size));
}

TEST(LightHandles, draggingAlongAnAxisFollowsTheCursorOnThatAxis) {
    const ViewFrame frame = someFrame();
    const glm::dvec3 center(0.1, 0.2, 0.3);
    for (const HandlePart handlePart : {HandlePart::X, HandlePart::Y, HandlePart::Z}) {
        const glm::dvec3 stopCriteria = center + 0.7 * axisOf(handlePart);
        const glm::dvec3 moved =
            dragged(frame, center, handlePart, *frame.project(center), *frame.project(stopCriteria));
        EXPECT_LT(glm::distance(moved, stopCriteria), 1e-9);
    }
}

TEST(LightHandles, draggingFreelyKeepsTheDepthAndFollowsTheCursor) {
    const ViewFrame frame = someFrame();
    const glm::dvec3 center(0.1, 0.2, 0.3);
    const glm::dvec2 start = *frame.project(center), end = start + glm::dvec2(50.0, -30.0);
    const glm::dvec3 moved = dragged(frame, center, HandlePart::Free, start, end);
    EXPECT_LT(glm::distance(*frame.project(moved), end), 1e-9);
    EXPECT_NEAR(glm::dot(moved - center, frame.forward), 0.0, 1e-12);
}

TEST(LightHandles, anAxisSeenEndOnDoesNotMove) {
    CameraDescription camera;
    camera.lookFrom = {0.0f, 0.0f, 5.0f};
    const ViewFrame frame = viewFrame(camera, 640, 480);
    EXPECT_EQ(dragged(frame, glm::dvec3(0.0), HandlePart::Z, {320.0, 240.0}, {330.0, 250.0}),
              glm::dvec3(0.0));
}

TEST(LightHandles, aClickPicksTheNearestLight) {
    const ViewFrame frame = someFrame();
    const std::vector<Light> lights{Light{PointLight{glm::vec3(0), Rgb(1)}}, kSegment};
    const auto pick = pickLight(frame, lights, *frame.project({2.0, 0.0, 0.0}) + glm::dvec2(2.0, 1.0), 10.0);
    ASSERT_TRUE(pick);
    EXPECT_EQ(pick->light, 1);
    EXPECT_EQ(pick->handle, 2);
    EXPECT_FALSE(pickLight(frame, lights, {5.0, 5.0}, 10.0));
}

TEST(LightHandles, aClickOnTheOutlinePicksTheWholeLight) {
    const ViewFrame frame = someFrame();
    const glm::dvec2 onEdge = *frame.project({0.5, 0.0, 0.0});
    const auto pick = pickLight(frame, {kParallelogram}, onEdge + glm::dvec2(1.0, 1.0), 5.0);
    ASSERT_TRUE(pick);
    EXPECT_EQ(pick->light, 0);
    EXPECT_EQ(pick->handle, 0);
}

}  // namespace
}  // namespace rayscope::viewer
