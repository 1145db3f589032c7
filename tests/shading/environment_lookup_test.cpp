#include "shading/environment_lookup.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "support/environments.h"
#include "support/statistics.h"

namespace rayscope {
namespace {

glm::dvec3 anyDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

TEST(CubePoint, InvertsCubeDirection) {
    std::mt19937 random(1);
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < 20000; ++i) directions.push_back(anyDirection(random));
    for (const double a : {-1.0, 0.0, 1.0})  // every tie between faces
        for (const double b : {-1.0, 0.0, 1.0})
            for (const double c : {-1.0, 0.0, 1.0})
                if (a != 0.0 || b != 0.0 || c != 0.0)
                    directions.push_back(glm::normalize(glm::dvec3(a, b, c)));
    for (const glm::dvec3& d : directions) {
        const shading::CubePoint p = shading::cubePoint(d);
        ASSERT_TRUE(p.face >= 0 && p.face < 6 && p.s >= 0.0 && p.s <= 1.0 && p.t >= 0.0 && p.t <= 1.0);
        EXPECT_LT(glm::distance(glm::normalize(shading::cubeDirection(p.face, p.s, p.t)), d), 1e-15);
    }
}

const glm::dvec3 kAxis = glm::normalize(glm::dvec3(0.3, 0.7, -0.4));
Rgb gradient(const glm::dvec3& d) { return Rgb(static_cast<float>(0.5 + 0.5 * glm::dot(d, kAxis))); }

TEST(EnvironmentLookup, OfAGradientIsTheGradient) {
    std::mt19937 random(2);
    const auto cube = test::cubeOf(128, gradient), equirect = test::equirectOf(512, 256, gradient);
    double worstCube = 0.0, worstEquirect = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 d = anyDirection(random);
        const double exact = 0.5 + 0.5 * glm::dot(d, kAxis);
        test::updateWorst(worstCube, std::abs(shading::lookup(*cube, d).x - exact));
        test::updateWorst(worstEquirect, std::abs(shading::lookup(*equirect, d).x - exact));
    }
    // The error of the interpolation is of second order within a face; across an edge, where texels of two
    // faces are interpolated, up to half a texel.
    EXPECT_LT(worstCube, 1.5e-3);
    EXPECT_LT(worstEquirect, 1.5e-4);
    test::reportDeviation("environment look-up, cube of 128", worstCube, "absolute");
    test::reportDeviation("environment look-up, equirectangular 512 x 256", worstEquirect, "absolute");
}

/// Along a path across edges and corners in small steps the map changes by less than a quarter of a texel's
/// change per step; clamping at the edges would give a whole one.
TEST(EnvironmentLookup, HasNoSeamsAtEdgesAndCorners) {
    constexpr int kSize = 128;
    const auto cube = test::cubeOf(kSize, gradient);
    const auto jumpAt = [&](const glm::dvec3& d, const glm::dvec3& across) {
        const glm::dvec3 a = glm::normalize(d - 1e-9 * across), b = glm::normalize(d + 1e-9 * across);
        return std::abs(shading::lookup(*cube, a).x - shading::lookup(*cube, b).x);
    };
    const double lipschitz = 0.5;
    double worst = 0.0;
    for (int along = 0; along < 3; ++along)  // all twelve edges, with the corners at their ends
        for (const double a : {-1.0, 1.0})
            for (const double b : {-1.0, 1.0})
                for (int i = 0; i <= 1000; ++i) {
                    glm::dvec3 point, across(0.0);
                    point[along] = 2.0 * i / 1000.0 - 1.0;
                    point[(along + 1) % 3] = across[(along + 1) % 3] = a;
                    point[(along + 2) % 3] = b;
                    across[(along + 2) % 3] = -b;
                    test::updateWorst(worst, jumpAt(point, across));
                }
    EXPECT_LT(worst, 0.5 * 2.0 * lipschitz / kSize);
    test::reportDeviation("environment, jump over the edges of a cube of 128", worst, "absolute");

    const auto equirect = test::equirectOf(512, 256, gradient);
    for (const glm::dvec3& d : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0.3, 1)}) {
        const glm::dvec3 a = glm::normalize(d + glm::dvec3(1e-9, 0, 0)),
                         b = glm::normalize(d - glm::dvec3(1e-9, 0, 0));
        EXPECT_NEAR(shading::lookup(*equirect, a).x, shading::lookup(*equirect, b).x, 1e-6);
    }
}

/// Each face lies on the axis of its name, and its image is upright and not mirrored for a viewer inside. The
/// corners of the images are written out by hand: upper left, upper right, lower left, lower right.
TEST(EnvironmentLookup, FacesAreSeenFromInside) {
    const glm::dvec3 corners[6][4] = {{{1, 1, -1}, {1, 1, 1}, {1, -1, -1}, {1, -1, 1}},
                                      {{-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}},
                                      {{1, 1, -1}, {-1, 1, -1}, {1, 1, 1}, {-1, 1, 1}},
                                      {{1, -1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, -1, -1}},
                                      {{1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {-1, -1, 1}},
                                      {{-1, 1, -1}, {1, 1, -1}, {-1, -1, -1}, {1, -1, -1}}};
    for (int face = 0; face < 6; ++face) {
        auto environment = std::make_shared<Environment>();
        for (auto& texture : environment->cube)
            texture = std::make_shared<Texture>(Texture{"", RgbImage(2, 2), TextureWrap::Clamp});
        auto marked = std::make_shared<Texture>(Texture{"", RgbImage(2, 2), TextureWrap::Clamp});
        for (std::size_t i = 0; i < 4; ++i) marked->image.pixels[i] = Rgb(static_cast<float>(i + 1));
        environment->cube[static_cast<std::size_t>(face)] = marked;
        for (int i = 0; i < 4; ++i) {
            glm::dvec3 center = corners[face][i];
            for (int axis = 0; axis < 3; ++axis)
                if (axis != face / 2) center[axis] *= 0.5;  // the centre of the texel
            EXPECT_EQ(shading::lookup(*environment, center).x, i + 1) << face << ' ' << i;
        }
    }
}

TEST(EnvironmentLookup, IsDefinedForEveryDirection) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
    for (const auto& environment :
         {test::cubeOf(4, gradient), test::equirectOf(8, 4, gradient), test::equirectOf(7, 3, gradient)})
        for (const glm::dvec3& d : {glm::dvec3(0), glm::dvec3(nan, 0, 1), glm::dvec3(infinity, 0, 0),
                                    glm::dvec3(-0.0, 1, -0.0), glm::dvec3(1e-300, 0, 0),
                                    glm::dvec3(0, -1e300, 0), glm::dvec3(1, 1, 1), glm::dvec3(-1, -1, -1)}) {
            const double value = shading::lookup(*environment, d).x;
            EXPECT_TRUE(value >= 0.0 && value <= 1.0);
        }
}

}  // namespace
}  // namespace rayscope
