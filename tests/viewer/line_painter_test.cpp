#include "viewer/overlay/line_painter.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rayscope::viewer {
namespace {

constexpr std::uint32_t kBlack = 0xff000000u, kWhite = 0xffffffffu;

/// With the default look, -1 … 1 in the scene fills the canvas, and z is the depth from -1 to 1.
PaintCanvas blackCanvas(int width, int height) {
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, std::vector<std::uint32_t>(count, kBlack), {}};
}

/// The point of the scene at the centre of a pixel of that canvas.
glm::vec3 centerOf(const PaintCanvas& canvas, int x, int y, float z = 0.0f) {
    return {2.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(canvas.width) - 1.0f,
            2.0f * (static_cast<float>(y) + 0.5f) / static_cast<float>(canvas.height) - 1.0f, z};
}

std::uint32_t at(const PaintCanvas& canvas, int x, int y) {
    return canvas.pixels[static_cast<std::size_t>(y * canvas.width + x)];
}

long painted(const PaintCanvas& canvas) {
    return canvas.width * canvas.height - std::count(canvas.pixels.begin(), canvas.pixels.end(), kBlack);
}

TEST(LinePainter, ALineIsOnePixelPerRowOrColumnAndIncludesItsEnds) {
    const int ends[][4] = {{3, 4, 20, 4},  {20, 4, 3, 4},  {7, 2, 7, 25}, {7, 25, 7, 2},
                           {1, 1, 29, 13}, {29, 13, 1, 1}, {2, 28, 9, 3}, {5, 5, 5, 5}};
    for (const auto& [x0, y0, x1, y1] : ends) {
        PaintCanvas canvas = blackCanvas(32, 32);
        paintLines(canvas, {{centerOf(canvas, x0, y0), centerOf(canvas, x1, y1)}}, {});
        EXPECT_EQ(painted(canvas), std::max(std::abs(x1 - x0), std::abs(y1 - y0)) + 1);
        EXPECT_EQ(at(canvas, x0, y0), kWhite);
        EXPECT_EQ(at(canvas, x1, y1), kWhite);
        // No pixel is further than one from the line through the ends.
        const glm::dvec2 start(x0, y0), along(x1 - x0, y1 - y0);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                if (at(canvas, x, y) != kBlack && glm::length(along) > 0.0) {
                    const glm::dvec2 offset = glm::dvec2(x, y) - start;
                    EXPECT_LE(std::abs(along.x * offset.y - along.y * offset.x) / glm::length(along), 1.0);
                }
    }
}

TEST(LinePainter, ColoursAreMixedByOpacity) {
    PaintCanvas canvas = blackCanvas(4, 4);
    canvas.pixels.assign(16, 0xff804020u);
    const glm::vec3 point = centerOf(canvas, 1, 1);
    paintLines(canvas, {{point, point, {1.0f, 0.0f, 0.5f, 0.5f}}}, {});
    const std::uint32_t mixed = at(canvas, 1, 1);
    EXPECT_NEAR(static_cast<double>(mixed & 0xff), (0x20 + 255) / 2.0, 1.0);
    EXPECT_NEAR(static_cast<double>(mixed >> 8 & 0xff), 0x40 / 2.0, 1.0);
    EXPECT_NEAR(static_cast<double>(mixed >> 16 & 0xff), (0x80 + 128) / 2.0, 1.0);
    EXPECT_EQ(mixed >> 24, 0xffu);
    EXPECT_EQ(at(canvas, 2, 2), 0xff804020u);
}

TEST(LinePainter, HiddenPartsAreFainter) {
    PaintCanvas canvas = blackCanvas(16, 4);
    canvas.depth.assign(64, 1.0f);
    for (std::size_t y = 0; y < 4; ++y)
        for (std::size_t x = 8; x < 16; ++x) canvas.depth[y * 16 + x] = 0.25f;
    paintLines(canvas, {{centerOf(canvas, 0, 1), centerOf(canvas, 15, 1)}}, {glm::mat4(1.0f), 1.0f, 0.25f});
    EXPECT_EQ(at(canvas, 7, 1), kWhite) << "the depth of the line is 0.5";
    EXPECT_NEAR(static_cast<double>(at(canvas, 8, 1) & 0xff), 64.0, 1.0);
    // A line in the surface is not hidden by it.
    paintLines(canvas, {{centerOf(canvas, 8, 2, -0.5f), centerOf(canvas, 15, 2, -0.5f)}}, {});
    EXPECT_EQ(at(canvas, 12, 2), kWhite);
}

TEST(LinePainter, PatternsStartAtTheStartOfTheLine) {
    PaintCanvas canvas = blackCanvas(100, 4);
    const PaintOptions coarse{glm::mat4(1.0f), 0.5f, 1.0f};
    paintLines(canvas,
               {{centerOf(canvas, 0, 0), centerOf(canvas, 99, 0), glm::vec4(1.0f), LineStyle::Dashed}}, {});
    EXPECT_NEAR(static_cast<double>(painted(canvas)), 60.0, 10.0);
    EXPECT_EQ(at(canvas, 2, 0), kWhite);
    EXPECT_EQ(at(canvas, 8, 0), kBlack);
    EXPECT_EQ(at(canvas, 12, 0), kWhite);
    // One that begins 13 pixels to the left of the canvas has its first gap at 6 - 13 + 10 = 3.
    paintLines(canvas,
               {{centerOf(canvas, -13, 1), centerOf(canvas, 99, 1), glm::vec4(1.0f), LineStyle::Dashed}}, {});
    EXPECT_EQ(at(canvas, 1, 1), kWhite);
    EXPECT_EQ(at(canvas, 5, 1), kBlack);
    EXPECT_EQ(at(canvas, 9, 1), kWhite);
    // With half as many pixels to the unit, a dash is half as long.
    paintLines(canvas,
               {{centerOf(canvas, 0, 2), centerOf(canvas, 99, 2), glm::vec4(1.0f), LineStyle::Dashed}},
               coarse);
    EXPECT_EQ(at(canvas, 1, 2), kWhite);
    EXPECT_EQ(at(canvas, 4, 2), kBlack);
    EXPECT_EQ(at(canvas, 6, 2), kWhite);
}

TEST(LinePainter, PartsOutsideTheViewAreNotDrawn) {
    PaintCanvas canvas = blackCanvas(32, 32);
    const float huge = 1e30f, infinite = std::numeric_limits<float>::infinity(), nan = std::nanf("");
    paintLines(canvas,
               {{{-5, 0, 0}, {-2, 0, 0}},
                {{0, 3, 0}, {1, 2, 0}},
                {{0, 0, -3}, {0, 0, -2}},
                {{0, 0, 2}, {0, 0, 3}},
                {{nan, 0, 0}, {0, nan, 0}},
                {{nan, nan, nan}, {0, 0, 0}},
                {{infinite, 0, 0}, {-infinite, 0, 0}}},
               {});
    EXPECT_EQ(painted(canvas), 0);
    paintLines(canvas, {{{-huge, 0, 0}, {huge, 0, 0}}}, {});
    EXPECT_LE(painted(canvas), 32) << "at most its row";
    PaintCanvas empty;
    paintLines(empty, {{{-1, -1, 0}, {1, 1, 0}}}, {});
    paintBoxes(empty, {{{-1, -1, 0}, {1, 1, 0}}}, {});
}

/// Looks along -Z from z = 3 onto the cube -1 … 1.
glm::mat4 perspective() {
    CameraDescription camera;
    camera.lookFrom = {0.4f, 0.7f, 3};
    camera.fov = 60;
    SceneBounds bounds;
    bounds.lower = glm::vec3(-1);
    bounds.upper = glm::vec3(1);
    return viewProjection(viewFrame(camera, 64, 48), bounds);
}

TEST(LinePainter, ABoxHasTwelveEdges) {
    for (const float half : {0.3f, 0.9f, 8.0f}) {  // inside, large, around the camera
        const OverlayBox box{glm::vec3(-half), {half, 0.5f * half, half}, {1, 0.5f, 0, 1}, LineStyle::Dashed};
        PaintCanvas boxes = blackCanvas(64, 48), lines = boxes;
        OverlayLines edges;
        appendBox(edges, box.lower, box.upper, box.color, box.style, box.width);
        paintBoxes(boxes, {box}, {perspective()});
        paintLines(lines, edges, {perspective()});
        EXPECT_EQ(painted(boxes) > 0, painted(lines) > 0);
        long differing = 0;
        for (std::size_t i = 0; i < boxes.pixels.size(); ++i) differing += boxes.pixels[i] != lines.pixels[i];
        EXPECT_LE(differing, 4) << "corners are rounded in another order";
    }
}

TEST(LinePainter, TheNumberOfThreadsDoesNotMatter) {
    OverlayLines lines;
    OverlayBoxes boxes;
    for (int i = 0; i < 500; ++i) {
        const float a = static_cast<float>(i) * 0.7f, r = 0.002f * static_cast<float>(i);
        const glm::vec4 color{0.5f + 0.5f * std::sin(a), 0.3f, r, 0.7f};
        lines.push_back({{r * std::cos(a), r * std::sin(a), 0},
                         {std::sin(3 * a), 2 * std::cos(a), 0.3f},
                         color,
                         static_cast<LineStyle>(i % 3)});
        boxes.push_back(
            {{r * std::sin(a), r * std::cos(a), -0.3f}, {r * std::sin(a) + 0.1f, r, 0.2f}, color});
    }
    const auto paint = [&](int threads) {
        PaintCanvas canvas = blackCanvas(64, 48);
        canvas.depth.assign(canvas.pixels.size(), 0.8f);
        tbb::task_arena(threads).execute([&] {
            paintBoxes(canvas, boxes, {perspective(), 1.0f, 0.3f});
            paintLines(canvas, lines, {perspective(), 1.0f, 0.3f});
        });
        return canvas.pixels;
    };
    EXPECT_EQ(paint(1), paint(2));
    EXPECT_EQ(paint(1), paint(7));
}

}  // namespace
}  // namespace rayscope::viewer
