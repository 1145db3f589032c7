#include "probe/surface_report.h"

#include <gtest/gtest.h>

#include "math/frame.h"
#include "support/environments.h"
#include "support/test_scenes.h"

namespace rayscope {
namespace {

TEST(TexelQuad, ResultIsTheColorOfTheTracer) {
    for (const TextureFilter filter : {TextureFilter::Nearest, TextureFilter::Bilinear}) {
        Settings settings;
        settings.textureFilter = filter;
        const auto world = test::compileBuiltin("quad-textured", 24, settings);
        int found = 0;
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x) {
                const RayTree tree = probeSample(*world, 1, {x, y, 0});
                const auto quad = probe::texelsOf(*world, tree.nodes[0]);
                if (!quad) continue;
                ++found;
                EXPECT_EQ(quad->width, 2);
                double sum = 0.0;
                for (const auto& row : quad->weight) sum += row[0] + row[1];
                EXPECT_NEAR(sum, 1.0, 1e-12);
                for (int channel = 0; channel < 3; ++channel)
                    EXPECT_NEAR(quad->result[channel], tree.nodes[0].kd[channel], 1e-6) << x << " " << y;
            }
        EXPECT_GT(found, 100);
    }
}

TEST(TexelQuad, OfASphereIsTheColorOfTheTracer) {
    SceneDescription scene;
    scene.materials = {test::material(Rgb(0.5f))};
    RgbImage image(4, 2);
    for (std::size_t i = 0; i < 8; ++i) image.pixels[i] = Rgb(static_cast<float>(i + 1) / 8.0f);
    scene.materials[0].kdTexture = std::make_shared<Texture>(Texture{"t", image, TextureWrap::Repeat});
    scene.spheres = {{"s", {{0, 0, 0}, 1.0f}, 0, glm::vec3(0.0f)}};
    const auto world = test::compileScene(scene, {}, 24, 24);
    int found = 0;
    for (int i = 0; i < 24 * 24; ++i) {
        const RayTree tree = probeSample(*world, 1, {i % 24, i / 24, 0});
        const auto quad = probe::texelsOf(*world, tree.nodes[0]);
        ASSERT_EQ(quad.has_value(), tree.nodes[0].hit);
        if (!quad) continue;
        ++found;
        EXPECT_NEAR(quad->result.x, tree.nodes[0].kd.x, 1e-6);
    }
    EXPECT_GT(found, 100);
}

TEST(VertexNormals, InterpolateToTheShadingNormal) {
    const auto world = test::compileBuiltin("teapot", 24);
    int found = 0;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
            const RayTree tree = probeSample(*world, 1, {x, y, 0});
            const auto normals = probe::vertexNormalsOf(*world, tree.nodes[0], 0.0f);
            if (!normals) continue;
            ++found;
            glm::dvec3 mixed(0.0), position(0.0);
            for (int i = 0; i < 3; ++i) {
                mixed += normals->weight[i] * glm::dvec3(normals->normal[i]);
                position += normals->weight[i] * glm::dvec3(normals->position[i]);
            }
            mixed = glm::normalize(mixed);
            EXPECT_NEAR(std::abs(glm::dot(mixed, glm::dvec3(tree.nodes[0].normal))), 1.0, 1e-4);
            EXPECT_LT(glm::distance(position, glm::dvec3(tree.nodes[0].position)), 1e-4);
        }
    EXPECT_GT(found, 50);
    EXPECT_FALSE(probe::vertexNormalsOf(*test::compileBuiltin("spheres", 24), RayNode{}, 0.0f));
}

TEST(EnvironmentPoint, IsTheColorOfAMiss) {
    const auto world = test::compileBuiltin("environment", 24);
    int found = 0;
    for (int y = 0; y < 24; y += 2)
        for (int x = 0; x < 24; x += 2)
            for (const RayNode& node : probeSample(*world, 1, {x, y, 0}).nodes) {
                const auto point = probe::environmentOf(*world, node);
                ASSERT_EQ(point.has_value(), !node.hit);
                if (!point) continue;
                ++found;
                const RgbSum seen = surfaceColor(node);
                for (int channel = 0; channel < 3; ++channel)
                    EXPECT_NEAR(point->color[channel], seen[channel], 1e-5);
            }
    EXPECT_GT(found, 30);
}

TEST(EnvironmentPoint, WithReflectionMapIsTheReflectedColor) {
    Settings settings;
    settings.reflectionMap = true;
    const auto world = test::compileBuiltin("environment", 24, settings);
    int found = 0;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
            const RayNode node = probeSample(*world, 1, {x, y, 0}).nodes[0];
            if (!node.hit) continue;
            ++found;
            const auto point = probe::environmentOf(*world, node);
            ASSERT_TRUE(point);
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(point->color[channel], surfaceColor(node)[channel], 2e-3) << x << " " << y;
        }
    EXPECT_GT(found, 50);
}

TEST(GlossySquare, ContainsRaysWithinTheirDeviation) {
    Settings settings;
    settings.glossy = true;
    settings.glossySamples = 400;
    const auto world = test::compileBuiltin("cornell-glossy", 24, settings);
    int found = 0;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
            const RayTree tree = probeSample(*world, 1, {x, y, 0});
            for (const int node : probe::glossySurfaces(tree)) {
                const auto square = probe::glossySquareOf(*world, tree, node);
                ASSERT_TRUE(square);
                if (square->rays < 400) continue;  // deeper reflections take one ray each
                ++found;
                // A ray intersects the plane of the square at its displacement.
                const glm::dvec3 normal = glm::normalize(glm::dvec3(square->center - square->origin));
                double squares = 0.0, count = 0.0;
                for (const RayNode& child : tree.nodes) {
                    if (child.parent != node) continue;
                    const glm::dvec3 d(child.ray.direction);
                    const glm::dvec3 at = d * (0.3 / glm::dot(d, normal));
                    const glm::dvec3 offset = at - 0.3 * normal;
                    squares += glm::dot(offset, offset);
                    count += 2.0;
                }
                const double deviation = static_cast<double>(glm::length(square->right));
                EXPECT_NEAR(std::sqrt(squares / count) / deviation, 1.0, 0.15);
            }
        }
    EXPECT_GT(found, 5);
}

TEST(LensReport, RaysStartInTheOutlineAndConvergeAtTheFocus) {
    for (const LensShape shape : {LensShape::Disk, LensShape::Square, LensShape::Hexagon}) {
        Settings settings;
        settings.lensShape = shape;
        settings.lensSamples = 64;
        settings.sharpZone = 1e-4f;
        const auto world = test::compileBuiltin("spheres-dof", 24, settings);
        const auto lens = probe::lensOf(*world);
        ASSERT_TRUE(lens);
        float widest = 0.0f;
        for (const glm::vec3& corner : lens->outline)
            widest = std::max(widest, glm::distance(corner, lens->center));
        for (const RayNode& node : probeSample(*world, 1, {12, 2, 0}).nodes)
            if (node.parent < 0) {
                EXPECT_LE(glm::distance(node.ray.origin, lens->center), widest * 1.001f);
            }
        for (const glm::vec3& corner : lens->focus)
            EXPECT_NEAR(world->camera.depthOf(glm::dvec3(corner)), world->camera.focusDistance(), 1e-4);
        ASSERT_EQ(lens->sharpZone[1].size(), 4u);
    }
    Settings pinhole;
    pinhole.depthOfField = false;
    EXPECT_FALSE(probe::lensOf(*test::compileBuiltin("spheres-dof", 24, pinhole)));
}

}  // namespace
}  // namespace rayscope
