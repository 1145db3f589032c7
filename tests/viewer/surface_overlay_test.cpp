#include "viewer/overlay/surface_overlay.h"

#include <gtest/gtest.h>

namespace rayscope::viewer {
namespace {

TEST(SurfaceOverlay, NormalsStartAtTheirVertices) {
    probe::VertexNormals normals{
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}, {1, 0, 0}}, {0.2, 0.3, 0.5}};
    const OverlayLines lines = vertexNormalLines(normals, 2.0f);
    ASSERT_EQ(lines.size(), 6u);
    EXPECT_EQ(lines[4].from, glm::vec3(1, 0, 0));
    EXPECT_EQ(lines[4].to, glm::vec3(1, 0, 2));
    EXPECT_EQ(lines[5].to, glm::vec3(2, 1, 0));
}

TEST(SurfaceOverlay, TheGlossySquareHasItsTrueSize) {
    probe::GlossySquare square;
    square.center = {0, 0, 0.3f};
    square.right = {0.1f, 0, 0};
    square.up = {0, 0.2f, 0};
    const OverlayLines lines = glossySquareLines(square);
    ASSERT_EQ(lines.size(), 6u) << "two triangles and the axis";
    EXPECT_EQ(lines[0].to - lines[0].from, glm::vec3(0.2f, 0, 0));
    EXPECT_EQ(lines[1].to - lines[1].from, glm::vec3(0, 0.4f, 0));
    EXPECT_EQ(lines[5].from, glm::vec3(0.0f));
}

TEST(SurfaceOverlay, TheEnvironmentRayHasTheLookedUpColor) {
    probe::EnvironmentPoint point;
    point.direction = {0, 5, 0};
    point.color = {0.0f, 1.0f, 0.0f};
    const OverlayLines lines = environmentLines(point, {1, 1, 1}, 3.0f);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].to, glm::vec3(1, 4, 1));
    EXPECT_EQ(glm::vec3(lines[0].color), displayColor({0.0f, 1.0f, 0.0f}));
}

TEST(SurfaceOverlay, LensAndFocusAreClosedOutlines) {
    probe::LensReport lens;
    lens.outline = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    EXPECT_EQ(lensLines(lens).size(), 3u + 4u);
    lens.sharpZone[0] = lens.sharpZone[1] = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const OverlayLines lines = lensLines(lens);
    EXPECT_EQ(lines.size(), 3u + 4u + 8u);
    EXPECT_EQ(lines.back().style, LineStyle::Dashed);
    EXPECT_EQ(lines[2].to, lines[0].from);
}

}  // namespace
}  // namespace rayscope::viewer
