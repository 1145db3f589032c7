#include "viewer/overlay/traversal_overlay.h"

#include <gtest/gtest.h>

#include "viewer/overlay/palette.h"

namespace rayscope::viewer {
namespace {

/// The root is visited; its left child is pushed, the right one is a leaf whose first triangle is hit and
/// whose second is not; then the left child is culled, because it is behind the hit; a third box is missed.
struct HandMade {
    std::vector<glm::vec3> vertices{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}};
    std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 1}};
    AccelInput input{vertices, triangles, {}};
    probe::TraversalLog log;
    HandMade() {
        log.ray.direction = {0, 0, 2};
        log.boxes = {{0, -1, false, {0, 0, 0}, {4, 4, 8}},
                     {1, 0, true, {0, 0, 6}, {4, 4, 8}},
                     {2, 0, true, {0, 0, 4}, {4, 4, 6}},
                     {3, 0, true, {9, 9, 9}, {9, 9, 9}}};
        const float nan = std::numeric_limits<float>::quiet_NaN(), inf = log.ray.tMax;
        log.steps = {
            {probe::TraversalEvent::Visited, 0, 0.0f, inf}, {probe::TraversalEvent::Missed, 3, nan, inf},
            {probe::TraversalEvent::Pushed, 1, 3.0f, inf},  {probe::TraversalEvent::Visited, 2, 2.0f, inf},
            {probe::TraversalEvent::Hit, 0, 2.5f, inf},     {probe::TraversalEvent::NoHit, 1, nan, 2.5f},
            {probe::TraversalEvent::Culled, 1, 3.0f, 2.5f}};
    }
};

std::size_t countOf(const OverlayBoxes& boxes, glm::vec4 color) {
    return static_cast<std::size_t>(
        std::count_if(boxes.begin(), boxes.end(), [&](const OverlayBox& box) { return box.color == color; }));
}

TEST(TraversalOverlay, FinallyVisitedBoxesAreGreenAndCulledOnesPurple) {
    const HandMade made;
    TraversalOverlayOptions choice;
    EXPECT_TRUE(traversalBoxes(made.log, choice).empty());
    choice.shown = true;
    OverlayBoxes boxes = traversalBoxes(made.log, choice);
    EXPECT_EQ(boxes.size(), 3u);
    EXPECT_EQ(countOf(boxes, palette::kVisitedBox), 2u);
    EXPECT_EQ(countOf(boxes, palette::kCulledBox), 1u);
    choice.culled = false;
    choice.missed = true;
    boxes = traversalBoxes(made.log, choice);
    EXPECT_EQ(countOf(boxes, palette::kCulledBox), 0u);
    EXPECT_EQ(countOf(boxes, palette::kMissedBox), 1u);
    const OverlayLines lines = traversalLines(made.log, made.input, choice, 10.0f);
    EXPECT_EQ(lines.size(), 3u) << "the edges of the triangle that was hit";
    EXPECT_EQ(lines[0].color, palette::kHitPrimitive);
}

TEST(TraversalOverlay, EachStepShowsTheStateOfTheTraversal) {
    const HandMade made;
    TraversalOverlayOptions choice;
    choice.shown = choice.stepping = true;
    EXPECT_TRUE(traversalBoxes(made.log, choice).empty()) << "no box is tested before the first step";
    choice.step = 3;
    OverlayBoxes boxes = traversalBoxes(made.log, choice);
    EXPECT_EQ(countOf(boxes, palette::kPushedBox), 1u);
    EXPECT_EQ(countOf(boxes, palette::kCulledBox), 0u);
    EXPECT_EQ(boxes.back().lower, made.log.boxes[0].lower) << "the root is the current node";
    choice.step = 6;
    boxes = traversalBoxes(made.log, choice);
    EXPECT_EQ(boxes.back().lower, made.log.boxes[2].lower);
    // The interval ends at the hit, in units of the ray's direction.
    OverlayLines lines = traversalLines(made.log, made.input, choice, 10.0f);
    EXPECT_EQ(lines.back().to, glm::vec3(0, 0, 5));
    EXPECT_EQ(lines.size(), 3u + 3u + 1u) << "the triangle tested last, the one that was hit, the interval";
    choice.step = 1000;
    EXPECT_EQ(shownSteps(made.log, choice), made.log.steps.size());
}

TEST(TraversalOverlay, FollowsMovingGeometry) {
    HandMade made;
    made.log.shift = {0, 100, 0};
    TraversalOverlayOptions choice;
    choice.shown = true;
    EXPECT_EQ(traversalBoxes(made.log, choice)[0].lower, glm::vec3(0, 100, 0));
    EXPECT_EQ(traversalLines(made.log, made.input, choice, 10.0f)[0].from, glm::vec3(0, 100, 5));
}

}  // namespace
}  // namespace rayscope::viewer
