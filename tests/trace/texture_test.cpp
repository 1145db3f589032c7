// Texture mapping in the image: texel by texel, and towards the horizon.
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

const Rgb kTopLeft(1, 0, 0), kTopRight(0, 1, 0), kBottomLeft(0, 0, 1), kBottomRight(1, 1, 0.5f);

std::shared_ptr<Texture> twoByTwo(TextureWrap wrap) {
    auto texture = std::make_shared<Texture>();
    texture->image = RgbImage(2, 2);
    texture->image.pixels = {kTopLeft, kTopRight, kBottomLeft, kBottomRight};
    texture->wrap = wrap;
    return texture;
}

/// A unit square around the origin, seen from the front; `scale` stretches its texture coordinates about the
/// lower left corner.
SceneDescription texturedQuad(std::shared_ptr<const Texture> texture, float scale = 1.0f) {
    SceneDescription scene;
    scene.materials = {material(Rgb(0.3f))};
    scene.materials[0].kdTexture = std::move(texture);
    MeshInstance mesh = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    auto data = std::make_shared<MeshData>(*mesh.data);
    for (glm::vec2& uv : data->texCoords) uv *= scale;
    mesh.data = data;
    scene.meshes = {mesh};
    return scene;
}

RgbSum colorAt(SceneDescription scene, const glm::vec2& p, TextureFilter filter) {
    scene.cameras = {pointCamera({p.x, p.y, 2}, {p.x, p.y, 0})};
    Settings settings;
    settings.shading = false;
    settings.textureFilter = filter;
    return firstSample(*compileScene(scene, settings, 1, 1));
}

TEST(TextureMapping, ShowsFourTexelsUpright) {
    for (const TextureWrap wrap : {TextureWrap::Repeat, TextureWrap::Clamp}) {
        const SceneDescription scene = texturedQuad(twoByTwo(wrap));
        for (const float u : {0.01f, 0.25f, 0.49f})
            for (const float v : {0.01f, 0.25f, 0.49f}) {
                EXPECT_EQ(colorAt(scene, {u, v}, TextureFilter::Nearest), RgbSum(kBottomLeft));
                EXPECT_EQ(colorAt(scene, {u + 0.5f, v}, TextureFilter::Nearest), RgbSum(kBottomRight));
                EXPECT_EQ(colorAt(scene, {u, v + 0.5f}, TextureFilter::Nearest), RgbSum(kTopLeft));
                EXPECT_EQ(colorAt(scene, {u + 0.5f, v + 0.5f}, TextureFilter::Nearest), RgbSum(kTopRight));
            }
    }
    reportDeviation("texture mapping, 2 x 2 texels, nearest", 0.0);
}

TEST(TextureMapping, InterpolatesTexelsBilinearly) {
    double worst = 0.0;
    for (const TextureWrap wrap : {TextureWrap::Repeat, TextureWrap::Clamp}) {
        const SceneDescription scene = texturedQuad(twoByTwo(wrap));
        for (const double u : {0.3, 0.5, 0.65})
            for (const double v : {0.26, 0.5, 0.7}) {
                const double x = 2 * u - 0.5, y = 2 * v - 0.5;  // between the texels' centres
                const RgbSum expected = (1 - y) * ((1 - x) * RgbSum(kBottomLeft) + x * RgbSum(kBottomRight)) +
                                        y * ((1 - x) * RgbSum(kTopLeft) + x * RgbSum(kTopRight));
                const RgbSum measured = colorAt(scene, glm::vec2(u, v), TextureFilter::Bilinear);
                updateWorst(worst, glm::distance(measured, expected));
            }
    }
    EXPECT_LT(worst, 4 * kFloatRounding);
    reportDeviation("texture mapping, bilinear", worst, "absolute");
    EXPECT_NEAR(colorAt(texturedQuad(twoByTwo(TextureWrap::Clamp)), {0.1f, 0.1f}, TextureFilter::Bilinear).z,
                1.0, 1e-12);
    // With Repeat, the left edge is half-way to the right texel.
    EXPECT_NEAR(
        colorAt(texturedQuad(twoByTwo(TextureWrap::Repeat)), {1e-4f, 0.25f}, TextureFilter::Bilinear).x, 0.5,
        1e-3);
}

TEST(TextureMapping, RepeatsOrClampsBeyondItsEdges) {
    const SceneDescription repeated = texturedQuad(twoByTwo(TextureWrap::Repeat), 4.0f);
    const SceneDescription clamped = texturedQuad(twoByTwo(TextureWrap::Clamp), 4.0f);
    EXPECT_EQ(colorAt(repeated, {0.55f, 0.3f}, TextureFilter::Nearest), RgbSum(kBottomLeft));   // (2.2, 1.2)
    EXPECT_EQ(colorAt(repeated, {0.7f, 0.95f}, TextureFilter::Nearest), RgbSum(kTopRight));     // (2.8, 3.8)
    EXPECT_EQ(colorAt(clamped, {0.55f, 0.05f}, TextureFilter::Nearest), RgbSum(kBottomRight));  // (2.2, 0.2)
    EXPECT_EQ(colorAt(clamped, {0.7f, 0.95f}, TextureFilter::Nearest), RgbSum(kTopRight));
    const SceneDescription negative = texturedQuad(twoByTwo(TextureWrap::Repeat), -1.0f);
    EXPECT_EQ(colorAt(negative, {0.25f, 0.25f}, TextureFilter::Nearest),
              RgbSum(kTopRight));  // (−0.25, −0.25)
}

TEST(TextureMapping, OffOrWithoutATextureUsesTheMaterial) {
    SceneDescription scene = texturedQuad(twoByTwo(TextureWrap::Repeat));
    scene.cameras = {pointCamera({0.2f, 0.2f, 2}, {0.2f, 0.2f, 0})};
    Settings settings;
    settings.shading = false;
    settings.textureMapping = false;
    EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)), RgbSum(Rgb(0.3f)));
    auto bare = std::make_shared<MeshData>(*scene.meshes[0].data);
    bare->texCoords.clear();
    scene.meshes[0].data = bare;
    settings.textureMapping = true;
    EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)), RgbSum(Rgb(0.3f)));
}

/// A black and white checkerboard of 64 × 64 texels, repeated over a floor that reaches to the horizon.
SceneDescription checkeredFloor() {
    auto texture = std::make_shared<Texture>();
    texture->image = RgbImage(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) texture->image.at(x, y) = Rgb(static_cast<float>((x / 8 + y / 8) % 2));
    SceneDescription scene;
    scene.materials = {material(Rgb(0.0f))};
    scene.materials[0].kdTexture = texture;
    MeshInstance mesh = quad({-3e4f, 0, 3e4f}, {6e4f, 0, 0}, {0, 0, -6e4f});
    auto data = std::make_shared<MeshData>(*mesh.data);
    for (glm::vec2& uv : data->texCoords) uv *= 6e4f / 8.0f;  // one period of the image is 8 units wide
    mesh.data = data;
    scene.meshes = {mesh};
    CameraDescription camera;
    camera.lookFrom = {0, 1, 0};
    camera.lookAt = {0.3f, 1, -1};
    scene.cameras = {camera};
    return scene;
}

struct Brightness {
    double mean = 0.0, deviation = 0.0;
};
Brightness rowsBelowHorizon(TextureFilter filter, int spp, int first, int last) {
    constexpr int kSize = 128;
    Settings settings;
    settings.shading = false;
    settings.textureFilter = filter;
    settings.spp = spp;
    const auto world = compileScene(checkeredFloor(), settings, kSize, kSize);
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (int y = kSize / 2 + first; y < kSize / 2 + last; ++y)
        for (int x = 0; x < kSize; ++x, ++count) {
            const double value = pixelMean(*world, 0, x, y, spp).x;
            sum += value, squares += value * value;
        }
    const double mean = sum / count;
    return {mean, std::sqrt(squares / count - mean * mean)};
}

TEST(TextureMapping, OfACheckerboardFadesToTheMeanGreyAtTheHorizon) {
    // Pixels of the first rows below the horizon cover thousands of squares.
    const Brightness mipmap = rowsBelowHorizon(TextureFilter::Mipmap, 1, 1, 4);
    EXPECT_NEAR(mipmap.mean, 0.5, 1e-3);
    EXPECT_LT(mipmap.deviation, 2e-3);
    reportDeviation("checkerboard at the horizon, mipmap", std::abs(mipmap.mean - 0.5), "absolute");
    const Brightness nearest = rowsBelowHorizon(TextureFilter::Nearest, 1, 1, 4);
    EXPECT_GT(nearest.deviation, 0.45);  // control: aliasing without the mipmap
    // With many samples all filters have the same mean.
    for (const TextureFilter filter : {TextureFilter::Nearest, TextureFilter::Bilinear}) {
        const Brightness filtered = rowsBelowHorizon(filter, 256, 1, 4);
        EXPECT_NEAR(filtered.mean, 0.5, 4.0 * 0.5 / std::sqrt(256.0 * 3 * 128));
    }
}

TEST(TextureMapping, MipmapsAreSharpUpClose) {
    const Brightness near = rowsBelowHorizon(TextureFilter::Mipmap, 1, 50, 64);
    EXPECT_GT(near.deviation, 0.4);
}

}  // namespace
}  // namespace rayscope::test
