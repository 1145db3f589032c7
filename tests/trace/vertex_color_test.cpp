// Vertex colours in the image: interpolated, beside textures, transforms, motion and instances.
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

const std::vector<Rgb> kColors{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5f, 0.25f, 1}};

/// A unit square with a colour per corner, seen from the front.
SceneDescription coloredQuad() {
    SceneDescription scene;
    scene.materials = {material(Rgb(0.3f))};
    MeshInstance mesh = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    auto data = std::make_shared<MeshData>(*mesh.data);
    data->colors = kColors;
    mesh.data = data;
    mesh.vertexColors = true;
    scene.meshes = {mesh};
    return scene;
}

RgbSum colorAt(SceneDescription scene, const glm::vec3& p, bool shading = false) {
    scene.cameras = {pointCamera(p + glm::vec3(0, 0, 2), p)};
    Settings settings;
    settings.shading = shading;
    return firstSample(*compileScene(scene, settings, 1, 1));
}

/// By the barycentric weights in the triangle below (x > y) or above the diagonal.
RgbSum expectedAt(double x, double y) {
    const RgbSum a(kColors[0]), c(kColors[2]);
    if (x > y) return (1.0 - x) * a + (x - y) * RgbSum(kColors[1]) + y * c;
    return (1.0 - y) * a + x * c + (y - x) * RgbSum(kColors[3]);
}

TEST(VertexColors, ReplaceKdAndAreInterpolated) {
    double worst = 0.0;
    for (const float x : {0.1f, 0.4f, 0.8f})
        for (const float y : {0.05f, 0.5f, 0.95f})
            updateWorst(worst, glm::distance(colorAt(coloredQuad(), {x, y, 0}),
                                             expectedAt(static_cast<double>(x), static_cast<double>(y))));
    EXPECT_LT(worst, 4 * kFloatRounding);
    reportDeviation("vertex colours", worst, "absolute");
}

TEST(VertexColors, AreShadedAsKd) {
    SceneDescription scene = coloredQuad(), plain = scene;
    const RgbSum expected = expectedAt(0.75, 0.25);
    plain.meshes[0].vertexColors = false;
    plain.materials[0].kd = Rgb(expected);
    for (SceneDescription* s : {&scene, &plain}) s->lights = {pointLight({2, 3, 4}, {1, 2, 3})};
    const RgbSum shaded = colorAt(scene, {0.75f, 0.25f, 0}, true);
    EXPECT_GT(shaded.x, 0.1);
    EXPECT_LT(glm::distance(shaded, colorAt(plain, {0.75f, 0.25f, 0}, true)), 4 * kFloatRounding);
}

TEST(VertexColors, MultiplyTextures) {
    auto texture = std::make_shared<Texture>();
    texture->image = RgbImage(1, 1, Rgb(0.5f, 1.0f, 0.25f));
    SceneDescription scene = coloredQuad();
    scene.materials[0].kdTexture = texture;
    const RgbSum factor(texture->image.pixels[0]);
    EXPECT_LT(glm::distance(colorAt(scene, {0.6f, 0.2f, 0}), factor * expectedAt(0.6, 0.2)),
              4 * kFloatRounding);
    scene.meshes[0].vertexColors = false;
    EXPECT_EQ(colorAt(scene, {0.6f, 0.2f, 0}), factor);
}

TEST(VertexColors, FollowTransformsAndMotion) {
    SceneDescription scene = coloredQuad();
    scene.meshes[0].transform.scale = 2.0f;
    scene.meshes[0].transform.translate = {5, 0, 0};
    scene.meshes.push_back(quad({-9, -9, -9}, {1, 0, 0}, {0, 1, 0}));
    EXPECT_LT(glm::distance(colorAt(scene, {6.5f, 0.5f, 0}), expectedAt(0.75, 0.25)), 16 * kFloatRounding);
    scene.meshes[0].motion = {0, 0, -1};
    EXPECT_LT(glm::distance(colorAt(scene, {6.5f, 0.5f, 0}), expectedAt(0.75, 0.25)), 16 * kFloatRounding);
}

TEST(VertexColors, OfSharedDataAreShownByTheInstancesThatAskForThem) {
    SceneDescription scene = coloredQuad();
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].vertexColors = false;
    scene.meshes[1].transform.translate = {3, 0, 0};
    EXPECT_LT(glm::distance(colorAt(scene, {0.6f, 0.2f, 0}), expectedAt(0.6, 0.2)), 4 * kFloatRounding);
    EXPECT_EQ(colorAt(scene, {3.6f, 0.2f, 0}), RgbSum(Rgb(0.3f)));
}

TEST(VertexColors, AWorldThatShowsThemIsNotReusedForOneThatDoesNot) {
    SceneDescription scene = coloredQuad();
    scene.cameras = {pointCamera({0.6f, 0.2f, 2}, {0.6f, 0.2f, 0})};
    Settings settings;
    settings.shading = false;
    const auto shown = compileScene(scene, settings, 1, 1);
    scene.meshes[0].vertexColors = false;
    const auto hidden = trace::compile(
        {std::make_shared<const SceneDescription>(scene), settings, scene.cameras[0], 1, 1}, shown.get());
    EXPECT_EQ(firstSample(*hidden), RgbSum(Rgb(0.3f)));
    EXPECT_EQ(hidden->motionGroups[0].geometry->objects[0].colors, nullptr);
}

}  // namespace
}  // namespace rayscope::test
