#include "viewer/overlay/overlay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "viewer/overlay/debug_rays_overlay.h"
#include "viewer/overlay/light_overlay.h"

namespace rayscope::viewer {
namespace {

/// A camera ray that hits, its reflection that misses, and one shadow ray of each visibility.
RayTree handMadeTree() {
    RayTree tree;
    RayNode camera;
    camera.ray.origin = {0.0f, 0.0f, 5.0f};
    camera.hit = true;
    camera.position = {0.0f, 0.0f, 1.0f};
    camera.normal = {0.0f, 0.0f, 1.0f};
    RayNode reflection;
    reflection.parent = 0;
    reflection.kind = RayKind::Reflection;
    reflection.depth = 1;
    reflection.ray.origin = camera.position;
    reflection.ray.direction = {0.0f, 2.0f, 0.0f};
    tree.nodes = {camera, reflection};
    for (const Visibility visibility :
         {Visibility::Visible, Visibility::Occluded, Visibility::Attenuated, Visibility::FacingAway}) {
        ShadowRay shadow;
        shadow.from = camera.position;
        shadow.to = {0.0f, 3.0f, 0.0f};
        shadow.color = {0.0f, 0.0f, 1.0f};
        shadow.visibility = visibility;
        tree.shadowRays.push_back(shadow);
    }
    return tree;
}

DebugRayFilter nothing() {
    DebugRayFilter filter;
    for (const RayLegendEntry& entry : debugRayLegend()) filter.*entry.shown = false;
    return filter;
}

TEST(DebugRaysOverlay, drawsEachRayFromItsOriginToItsEnd) {
    DebugRayFilter filter = nothing();
    filter.camera = filter.reflections = filter.missed = true;
    const OverlayLines lines = debugRayLines(handMadeTree(), filter, 10.0f);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].from, glm::vec3(0.0f, 0.0f, 5.0f));
    EXPECT_EQ(lines[0].to, glm::vec3(0.0f, 0.0f, 1.0f));
    // Rays that miss are as long as the scene, whatever the length of their direction.
    EXPECT_EQ(lines[1].to, glm::vec3(0.0f, 10.0f, 1.0f));
    EXPECT_NE(lines[0].style, lines[1].style);
}

TEST(DebugRaysOverlay, showsTheVisibilityOfShadowRays) {
    DebugRayFilter filter = nothing();
    filter.camera = filter.shadowVisible = filter.shadowOccluded = filter.shadowBehindSurface = true;
    OverlayLines lines = debugRayLines(handMadeTree(), filter, 10.0f);
    ASSERT_EQ(lines.size(), 5u);
    lines.erase(lines.begin());
    EXPECT_LT(glm::distance(glm::vec3(lines[0].color), glm::vec3(0.0f, 0.0f, 1.0f)), 1e-6f)
        << "the light's colour";
    EXPECT_EQ(lines[0].style, LineStyle::Solid);
    EXPECT_GT(lines[1].color.r, 3.0f * lines[1].color.g) << "occluded is red";
    EXPECT_EQ(lines[1].style, LineStyle::Dotted);
    EXPECT_EQ(lines[2].style, LineStyle::Dashed);
}

TEST(DebugRaysOverlay, drawsNormalsAtHits) {
    DebugRayFilter filter = nothing();
    filter.normals = true;
    const OverlayLines lines = debugRayLines(handMadeTree(), filter, 10.0f);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].from, glm::vec3(0.0f, 0.0f, 1.0f));
    EXPECT_EQ(lines[0].to, glm::vec3(0.0f, 0.0f, 1.5f));
}

TEST(DebugRaysOverlay, maxDepthHidesLaterRays) {
    DebugRayFilter filter;
    const std::size_t all = debugRayLines(handMadeTree(), filter, 10.0f).size();
    filter.maxDepth = 0;
    EXPECT_EQ(debugRayLines(handMadeTree(), filter, 10.0f).size(), all - 1);
}

TEST(DebugRaysOverlay, everyRowOfTheLegendFiltersRays) {
    RayTree tree = handMadeTree();
    RayNode more = tree.nodes[0];
    more.parent = 0;
    for (const RayKind kind : {RayKind::Reflection, RayKind::Glossy, RayKind::Transparent}) {
        more.kind = kind;
        tree.nodes.push_back(more);
    }
    more.kind = RayKind::Glossy;
    more.hit = false;
    more.end = RayEnd::BelowSurface;
    tree.nodes.push_back(more);
    const std::size_t all = debugRayLines(tree, {}, 10.0f).size();
    for (const RayLegendEntry& entry : debugRayLegend()) {
        if (entry.shown == &DebugRayFilter::vertexNormals)
            continue;  // drawn from the world, not from the tree
        DebugRayFilter filter;
        filter.*entry.shown = false;
        EXPECT_LT(debugRayLines(tree, filter, 10.0f).size(), all) << entry.label;
    }
}

TEST(DebugRaysOverlay, hidesIsolatesAndSelects) {
    const RayTree tree = handMadeTree();
    DebugRayFilter filter;
    filter.normals = false;
    EXPECT_EQ(shownRays(tree, filter).size(), 6u);
    filter.hidden = {{1, -1}, {-1, 2}};
    EXPECT_EQ(shownRays(tree, filter).size(), 4u);
    filter.hidden.clear();
    filter.isolated = true;
    EXPECT_EQ(shownRays(tree, filter).size(), 6u) << "nothing is selected";
    filter.selected = {1, -1};
    EXPECT_EQ(shownRays(tree, filter), (std::vector<RaySelection>{{0, -1}, {1, -1}})) << "and its ancestors";
    filter.selected = {-1, 3};
    EXPECT_EQ(shownRays(tree, filter), (std::vector<RaySelection>{{0, -1}, {-1, 3}}));
    EXPECT_EQ(debugRayLines(tree, filter, 10.0f).size(), 3u) << "the selected ray has a halo";
    filter = {};
    filter.light = 1;
    EXPECT_EQ(shownRays(tree, filter).size(), 2u);
    filter.light = -1;
    filter.minContribution = 0.5f;
    EXPECT_TRUE(shownRays(tree, filter).empty());
}

TEST(DebugRaysOverlay, manyRaysAreDrawnWithTheWeightOfWhatTheyAdd) {
    RayTree tree;
    RayNode node;
    node.hit = true;
    tree.nodes = {node};
    const auto addShadowRays = [&](int count, double contribution) {
        for (int i = 0; i < count; ++i) {
            ShadowRay ray;
            ray.node = 0;
            ray.visibility = Visibility::Visible;
            ray.contribution = RgbSum(contribution);
            tree.shadowRays.push_back(ray);
        }
    };
    const DebugRayFilter filter;
    addShadowRays(10, 1.0);
    EXPECT_EQ(RayWeights(std::span(&tree, 1), filter).opacity(tree, {-1, 0}), 1.0f) << "few rays are opaque";
    addShadowRays(990, 0.01);
    const RayWeights many(std::span(&tree, 1), filter);
    const float strong = many.opacity(tree, {-1, 0}), weak = many.opacity(tree, {-1, 500});
    EXPECT_LT(strong, 0.4f);
    EXPECT_LT(weak, 0.6f * strong);
    EXPECT_GT(weak, 0.0f);
    const auto opacityOf = [&](RaySelection selected) {
        DebugRayFilter one = filter;
        one.selected = selected;
        one.isolated = true;
        one.normals = false;
        return debugRayLines(tree, one, 10.0f, many).back().color.a;
    };
    EXPECT_GT(opacityOf({-1, 500}), 0.8f) << "the selected ray stays as it is";
}

TEST(DebugRaysOverlay, darkSurfacesAreVisibleOnBlack) {
    RayTree tree;
    RayNode node;
    node.hit = true;
    DebugRayFilter filter = nothing();
    filter.camera = true;
    filter.colors = RayColors::Surface;
    for (const RgbSum dark : {RgbSum(0.0), RgbSum(0.0, 0.0, 0.002), RgbSum(0.01, 0.004, 0.001)}) {
        node.contribution = dark;
        tree.nodes = {node};
        const OverlayLine line = debugRayLines(tree, filter, 10.0f).at(0);
        EXPECT_GE(std::max({line.color.r, line.color.g, line.color.b}), 0.59f);
        EXPECT_GE(line.width, 2.0f);
        const bool isHueKept = line.color.g <= std::max(line.color.r, line.color.b);
        EXPECT_TRUE(isHueKept);
    }
}

TEST(DebugRaysOverlay, colorsShowSurfaceOrRadiance) {
    // A pane of half opacity shows red, and lets green through from behind.
    RayTree tree;
    RayNode pane, behind;
    pane.hit = behind.hit = true;
    pane.opacity = 0.5;
    pane.contribution = {0.4, 0.0, 0.0};
    behind.parent = 0;
    behind.kind = RayKind::Transparent;
    behind.throughput = glm::dvec3(0.5);
    behind.contribution = {0.0, 0.5, 0.0};
    tree.nodes = {pane, behind};
    DebugRayFilter filter = nothing();
    filter.camera = filter.transparent = true;
    filter.colors = RayColors::Surface;
    OverlayLines lines = debugRayLines(tree, filter, 10.0f);
    EXPECT_EQ(glm::vec3(lines[0].color), displayColor({0.8f, 0.0f, 0.0f}));
    EXPECT_EQ(lines[0].style, LineStyle::Dashed) << "transparent surfaces are dashed";
    EXPECT_EQ(lines[0].color.a, 1.0f) << "and not faded";
    EXPECT_EQ(glm::vec3(lines[1].color), displayColor({0.0f, 1.0f, 0.0f}));
    EXPECT_EQ(lines[1].style, LineStyle::Solid);
    filter.colors = RayColors::IncomingRadiance;
    lines = debugRayLines(tree, filter, 10.0f);
    EXPECT_EQ(glm::vec3(lines[0].color), displayColor({0.4f, 0.5f, 0.0f}));
    EXPECT_EQ(glm::vec3(lines[1].color), displayColor({0.0f, 1.0f, 0.0f}));
}

TEST(DebugRaysOverlay, aClickPicksTheNearestRayInFrontOfTheCamera) {
    const RayTree tree = handMadeTree();
    CameraDescription camera;
    camera.lookFrom = {10.0f, 1.0f, 2.0f};
    camera.lookAt = {0.0f, 1.0f, 2.0f};
    const ViewFrame frame = viewFrame(camera, 800, 600);
    DebugRayFilter filter;
    const auto pickAt = [&](glm::dvec3 point) {
        return pickRay(tree, filter, frame, *frame.project(point), 5.0, 10.0f);
    };
    EXPECT_EQ(pickAt({0, 0, 3}), (RaySelection{0, -1}));
    EXPECT_EQ(pickAt({0, 4.5, 1}), (RaySelection{1, -1}));
    EXPECT_TRUE(pickAt({0, 2, 4}).empty());
    filter.camera = false;
    EXPECT_TRUE(pickAt({0, 0, 3}).empty()) << "hidden rays cannot be picked";
    // The camera looks away: everything lies behind it.
    camera.lookAt = {20.0f, 1.0f, 2.0f};
    EXPECT_TRUE(pickRay(tree, {}, viewFrame(camera, 800, 600), {400, 300}, 5000.0, 10.0f).empty());
}

TEST(DebugRaysOverlay, everyKindDiffersByColorOrStyle) {
    const std::vector<RayLegendEntry> legend = debugRayLegend();
    for (std::size_t i = 0; i < legend.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_TRUE(legend[i].color != legend[j].color || legend[i].style != legend[j].style);
}

TEST(Overlay, aBoxHasTwelveEdgesAlongTheAxes) {
    OverlayLines lines;
    appendBox(lines, {0, 0, 0}, {1, 2, 3}, glm::vec4(1.0f));
    ASSERT_EQ(lines.size(), 12u);
    glm::vec3 sum(0.0f);
    for (const OverlayLine& line : lines) sum += glm::abs(line.to - line.from);
    EXPECT_EQ(sum, glm::vec3(4, 8, 12));
}

TEST(Overlay, displayColorKeepsTheHueOfBrightLights) {
    EXPECT_LT(glm::distance(displayColor(Rgb(15.0f)), glm::vec3(1.0f)), 1e-6f);
    const glm::vec3 orange = displayColor({20.0f, 10.0f, 0.0f});
    EXPECT_NEAR(orange.r, 1.0f, 1e-6f);
    EXPECT_NEAR(orange.g, 0.7354f, 1e-3f);  // sRGB of one half
    EXPECT_EQ(orange.b, 0.0f);
}

TEST(LightOverlay, symbolsOfPointLightsHaveAConstantSizeOnTheScreen) {
    CameraDescription camera;
    camera.lookFrom = {0.0f, 0.0f, 10.0f};
    const ViewFrame frame = viewFrame(camera, 800, 600);
    const auto radiusOf = [&](glm::vec3 point) {
        double reach = 0.0;
        for (const OverlayLine& line : lightLines({Light{PointLight{point, Rgb(1)}}}, -1, frame, 1.0))
            reach = std::max(
                reach, glm::distance(*frame.project(glm::dvec3(line.to)), *frame.project(glm::dvec3(point))));
        return reach;
    };
    EXPECT_NEAR(radiusOf({0, 0, 5}), radiusOf({0, 0, -50}), 0.05);
}

TEST(LightOverlay, segmentsHaveAColorGradient) {
    const Light light{SegmentLight{{glm::vec3(0), glm::vec3(1, 0, 0)}, {Rgb(1, 0, 0), Rgb(0, 0, 1)}}};
    const OverlayLines lines = lightLines({light}, -1, viewFrame(CameraDescription{}, 100, 100), 1.0);
    EXPECT_LT(glm::distance(glm::vec3(lines.front().color), glm::vec3(1, 0, 0)), 1e-6f);
    EXPECT_THAT(lines, testing::Contains(testing::Truly([](const OverlayLine& line) {
                    return line.color.b > line.color.r && line.from.x > 0.5f && line.from.x < 1.0f;
                })));
}

}  // namespace
}  // namespace rayscope::viewer
