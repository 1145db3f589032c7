// Warnings for scenes outside the range in which hits are proven correct, and for no others.
#include "scene/lint_range.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/generate/generate.h"

namespace rayscope {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

SceneDescription sphereMesh(const Transform& transform) {
    SceneDescription scene;
    scene.materials.emplace_back();
    scene.meshes.push_back(
        {.name = "ball",
         .data = std::make_shared<MeshData>(scene::generate(scene::IcosphereShape{.subdivisions = 3})),
         .transform = transform,
         .materials = {0}});
    return scene;
}

std::string textOf(const SceneDescription& scene) {
    std::string text;
    for (const Diagnostic& found : scene::lintRange(scene)) {
        EXPECT_EQ(found.severity, Severity::Warning);
        text += toString(found) + "\n";
    }
    return text;
}

Transform scaled(float scale) {
    Transform transform;
    transform.scale = scale;
    return transform;
}

Transform movedTo(const glm::vec3& position, float scale = 1.0f) {
    Transform transform = scaled(scale);
    transform.translate = position;
    return transform;
}

TEST(LintRange, HasNoWarningWithinTheRange) {
    EXPECT_THAT(textOf({}), IsEmpty());
    for (const int exponent : {-55, -20, 0, 20, 55})
        EXPECT_THAT(textOf(sphereMesh(scaled(std::ldexp(1.0f, exponent)))), IsEmpty()) << exponent;
    EXPECT_THAT(textOf(sphereMesh(movedTo({1e4f, -1e4f, 0}))), IsEmpty());
    SceneDescription sphere;
    sphere.spheres.push_back({"s", {{1e5f, 0, 0}, 1.0f}, 0, glm::vec3(0)});
    EXPECT_THAT(textOf(sphere), IsEmpty());
}

TEST(LintRange, WarnsAboutSizesOutOfRange) {
    EXPECT_THAT(textOf(sphereMesh(scaled(0x1p62f))),
                HasSubstr("hits are proven correct from 8.7e-19 to 1.2e+18"));
    EXPECT_THAT(textOf(sphereMesh(scaled(0x1p-63f))), HasSubstr("hits are proven correct from"));
    EXPECT_THAT(textOf(sphereMesh(scaled(0.0f))), HasSubstr("the scene has a size of 0"));
}

TEST(LintRange, WarnsAboutDistantScenes) {
    const std::string text = textOf(sphereMesh(movedTo({1e7f, 0, 0})));
    EXPECT_THAT(text, HasSubstr("from the origin, 2.9e+06 times its size"));
    EXPECT_THAT(
        text,
        HasSubstr("of 1280 triangles have edges shorter than 4 float steps, which are up to 1 units there"));
}

TEST(LintRange, IsPartOfLint) {
    const Diagnostics found = lint(sphereMesh(movedTo({1e7f, 0, 0})));
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const Diagnostic& d) {
        return d.message.find("move it closer") != std::string::npos;
    }));
}

TEST(LintRange, WarnsAboutShapesDominatedByRounding) {
    // The edges are about 0.15 long; steps of float are 0.0625 at a million and 0.0078 at a hundred thousand.
    EXPECT_THAT(textOf(sphereMesh(movedTo({1e6f, 0, 0}))), HasSubstr("rounding dominates their shape"));
    EXPECT_THAT(textOf(sphereMesh(movedTo({1e5f, 0, 0}))), IsEmpty());
    SceneDescription sphere;
    sphere.spheres.push_back({"dot", {{1e6f, 0, 0}, 0.2f}, 0, glm::vec3(0)});
    EXPECT_THAT(textOf(sphere), HasSubstr("sphere 'dot': its radius 0.2 is less than 4 float steps"));
}

TEST(LintRange, WarnsAboutOverflow) {
    EXPECT_THAT(textOf(sphereMesh(movedTo({3e38f, 0, 0}, 2e38f))), HasSubstr("overflow float"));
    SceneDescription nonFinite = sphereMesh({});
    auto data = std::make_shared<MeshData>(*nonFinite.meshes[0].data);
    data->positions[4].x = std::nanf("");  // lint() warns about it
    nonFinite.meshes[0].data = data;
    EXPECT_THAT(textOf(nonFinite), IsEmpty());
}

}  // namespace
}  // namespace rayscope
