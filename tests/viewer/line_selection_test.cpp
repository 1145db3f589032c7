#include "viewer/overlay/line_selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rayscope::viewer {
namespace {

/// Looks along -Z from z = 5; the plane z = 0 is 600 pixels high.
ViewFrame frameOf600Pixels() {
    CameraDescription camera;
    camera.lookFrom = {0, 0, 5};
    camera.fov = 90;
    return viewFrame(camera, 800, 600);
}

/// Lines from the middle of the picture to points on a circle of radius 2.
OverlayLines fan(int count) {
    OverlayLines lines;
    for (int i = 0; i < count; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(count);
        lines.push_back({{0, 0, 0}, {2.0f * std::cos(angle), 2.0f * std::sin(angle), 0}});
    }
    return lines;
}

TEST(LineSelection, CostsAreLengthsWithinThePicture) {
    const ViewFrame frame = frameOf600Pixels();
    const double start = drawingCost({{{0, 0, 10}, {1, 0, 10}}}, frame);
    EXPECT_GT(start, 0.0) << "behind the camera: only the constant cost of a line";
    EXPECT_NEAR(drawingCost({{{0, 0, 0}, {1, 0, 0}}}, frame), start + 60.0, 1e-3);
    EXPECT_NEAR(drawingCost({{{-1000, 0, 0}, {1000, 0, 0}}}, frame), start + 800.0, 1e-3);
    EXPECT_NEAR(drawingCost({{{0, -1000, 0}, {0, 1000, 0}}}, frame), start + 600.0, 1e-3);
    EXPECT_NEAR(drawingCost({{{-1000, 50, 0}, {1000, 50, 0}}}, frame), start, 1e-3) << "above the picture";
    EXPECT_EQ(drawingCost({}, frame), 0.0);
    const float nan = std::nanf("");
    EXPECT_FALSE(drawingCost({{{nan, 0, 0}, {1, nan, 0}}}, frame) > 1e6);
}

TEST(LineSelection, KeepsAllThatTheBudgetAllows) {
    const OverlayLines lines = fan(100);
    EXPECT_EQ(selectLines(lines, frameOf600Pixels(), 1e9).size(), 100u);
    EXPECT_EQ(selectLines(lines, frameOf600Pixels(), std::numeric_limits<double>::infinity()).size(), 100u);
    EXPECT_TRUE(selectLines({}, frameOf600Pixels(), 0.0).empty());
}

TEST(LineSelection, SelectsAnEvenSubsetWithinTheBudget) {
    const ViewFrame frame = frameOf600Pixels();
    const OverlayLines lines = fan(10000);
    const double budget = 50000.0;
    const OverlayLines chosen = selectLines(lines, frame, budget);
    EXPECT_NEAR(drawingCost(chosen, frame), budget, 0.05 * budget);
    // About as many in each quarter of the circle.
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f}) {
            const auto inQuarter = std::count_if(chosen.begin(), chosen.end(), [&](const OverlayLine& line) {
                return line.to.x * x > 0.0f && line.to.y * y > 0.0f;
            });
            EXPECT_NEAR(static_cast<double>(inQuarter), 0.25 * static_cast<double>(chosen.size()), 5.0);
        }
    // A smaller budget selects a subset of the same lines, so that nothing flickers while the camera moves.
    for (const OverlayLine& line : selectLines(lines, frame, 0.5 * budget))
        EXPECT_TRUE(std::any_of(chosen.begin(), chosen.end(),
                                [&](const OverlayLine& other) { return other.to == line.to; }));
}

TEST(LineSelection, KeepsOneOfLinesWithTheSameAppearance) {
    const ViewFrame frame = frameOf600Pixels();
    OverlayLines lines(5000, {{0, 0, 0}, {2, 0, 0}});
    EXPECT_EQ(selectLines(lines, frame, 1000.0).size(), 1u);
    lines[4000].style = LineStyle::Dashed;
    lines[4500].color = {1.0f, 0.0f, 0.0f, 1.0f};
    EXPECT_EQ(selectLines(lines, frame, 1000.0).size(), 3u) << "another colour is another appearance";
}

TEST(LineSelection, KeepsBoldLines) {
    OverlayLines lines = fan(2000);
    for (std::size_t i = 0; i < lines.size(); i += 100) lines[i].width = kBoldWidth;
    const OverlayLines chosen = selectLines(lines, frameOf600Pixels(), 5000.0);
    EXPECT_EQ(std::count_if(chosen.begin(), chosen.end(), isBold), 20);
    EXPECT_LT(chosen.size(), 100u);
}

}  // namespace
}  // namespace rayscope::viewer
