// Textures on analytic spheres: longitude and latitude, as on the generated UV sphere.
#include "math/vectors.h"
#include "scene/generate/generate.h"
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

/// Smooth, different everywhere, and without a jump at the seam.
std::shared_ptr<Texture> smoothTexture() {
    auto texture = std::make_shared<Texture>();
    constexpr int kWidth = 128, kHeight = 64;
    texture->image = RgbImage(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float turn = 6.2831853f * (static_cast<float>(x) + 0.5f) / kWidth;
            texture->image.at(x, y) = {0.5f + 0.4f * std::sin(turn), 0.5f + 0.4f * std::cos(turn),
                                       (static_cast<float>(y) + 0.5f) / kHeight};
        }
    return texture;
}

SceneDescription texturedSphere(const Sphere& sphere, const glm::vec3& motion = glm::vec3(0.0f)) {
    SceneDescription scene;
    scene.materials = {material(Rgb(0.3f))};
    scene.materials[0].kdTexture = smoothTexture();
    scene.spheres = {{"s", sphere, 0, motion}};
    return scene;
}

Settings unlit(TextureFilter filter = TextureFilter::Bilinear) {
    Settings settings;
    settings.shading = false;
    settings.textureFilter = filter;
    return settings;
}

glm::vec2 uvSeenFrom(const glm::vec3& eye, SceneDescription scene, const glm::vec3& at) {
    scene.cameras = {pointCamera(eye, at)};
    RecordingObserver observer;
    pixelMean(*compileScene(scene, unlit(), 1, 1), 0, 0, 0, 1, observer);
    EXPECT_EQ(observer.hits.size(), 1u);
    return observer.hits.empty() ? glm::vec2(-1.0f) : observer.hits[0].uv;
}

TEST(SphereTexture, HasLongitudeAndLatitude) {
    const struct {
        glm::vec3 direction;
        glm::vec2 uv;
    } cases[] = {{{0, 0, -1}, {0.25f, 0.5f}},
                 {{-1, 0, 0}, {0.5f, 0.5f}},
                 {{0, 0, 1}, {0.75f, 0.5f}},
                 {{1, 1, -1}, {0.125f, 0.5f + std::asin(std::sqrt(1.0f / 3.0f)) / 3.14159265f}},
                 {{-1, -1, 1}, {0.625f, 0.5f - std::asin(std::sqrt(1.0f / 3.0f)) / 3.14159265f}}};
    for (const float size : {1e-40f, 1e-25f, 1e-3f, 1.0f, 1e20f, 1e36f})
        for (const glm::vec3& moved : {glm::vec3(0.0f), glm::vec3(2.0f, -1.0f, 0.5f)}) {
            const Sphere sphere{size * moved, size};
            for (const auto& c : cases)
                for (const float distance : {3.0f, 0.25f}) {  // from outside and from inside
                    const glm::vec3 unit = glm::normalize(c.direction);
                    const glm::vec2 uv =
                        uvSeenFrom(size * (moved + distance * unit), texturedSphere(sphere),
                                   distance > 1.0f ? sphere.center : size * (moved + 2.0f * unit));
                    EXPECT_NEAR(uv.x, c.uv.x, size < 1e-37f ? 1e-4f : 1e-5f) << size;
                    EXPECT_NEAR(uv.y, c.uv.y, size < 1e-37f ? 1e-4f : 1e-5f) << size;
                }
            // u jumps at the seam, where it is 0 or nearly 1; v stays below 1 at the pole.
            const float seam =
                uvSeenFrom(size * (moved + glm::vec3(3, 0, 0)), texturedSphere(sphere), sphere.center).x;
            EXPECT_TRUE(seam < 1e-4f || seam > 1.0f - 1e-4f) << seam;
            const glm::vec2 top =
                uvSeenFrom(size * (moved + glm::vec3(0, 3, 0)), texturedSphere(sphere), sphere.center);
            EXPECT_TRUE(top.y > 0.999f && top.y < 1.0f && top.x >= 0.0f && top.x <= 1.0f);
            const glm::vec2 bottom =
                uvSeenFrom(size * (moved - glm::vec3(0, 3, 0)), texturedSphere(sphere), sphere.center);
            EXPECT_TRUE(bottom.y >= 0.0f && bottom.y < 0.001f);
        }
}

TEST(SphereTexture, IsThePictureOfTheGeneratedUvSphere) {
    constexpr int kSize = 32;
    double worst = 0.0;
    for (const TextureFilter filter :
         {TextureFilter::Nearest, TextureFilter::Bilinear, TextureFilter::Mipmap})
        for (const glm::vec3& eye : {glm::vec3(0, 0, 3), glm::vec3(3, 0.5f, 0.2f), glm::vec3(0.1f, 3, 0.2f),
                                     glm::vec3(-2, -2, 1), glm::vec3(0.1f, 0.05f, 0.2f)}) {
            SceneDescription analytic = texturedSphere({glm::vec3(0.0f), 1.0f}), mesh = analytic;
            mesh.spheres.clear();
            scene::UvSphereShape shape;
            shape.segments = 2048;
            shape.rings = 1024;
            mesh.meshes = {{"m", std::make_shared<MeshData>(scene::generate(shape)), {}, {0}}};
            CameraDescription camera;
            camera.lookFrom = eye;
            camera.lookAt = glm::length(eye) < 1.0f ? glm::vec3(2, 1, 1) : glm::vec3(0.0f);
            analytic.cameras = mesh.cameras = {camera};
            const auto a = compileScene(analytic, unlit(filter), kSize, kSize),
                       b = compileScene(mesh, unlit(filter), kSize, kSize);
            double sum = 0.0;
            for (int i = 0; i < kSize * kSize; ++i)
                sum += glm::distance(pixelMean(*a, 0, i % kSize, i / kSize, 1),
                                     pixelMean(*b, 0, i % kSize, i / kSize, 1));
            updateWorst(worst, sum / (kSize * kSize));
        }
    // Single pixels differ at the silhouette and, with the nearest texel, at the edges of texels.
    EXPECT_LT(worst, 3e-3);
    reportDeviation("texture of a sphere and of a fine UV sphere, mean", worst, "absolute");
}

TEST(SphereTexture, MovesWithTheSphereAndIsFiniteEverywhere) {
    SceneDescription moving = texturedSphere({{-1, 0, 0}, 1.0f}, {2, 0, 0});
    moving.cameras = {frontCamera(1.5f)};
    SceneDescription odd = texturedSphere({{0, 0, 0}, 1.0f});
    odd.spheres.push_back({"tiny", {{0, 0, 2}, 1e-44f}, 0, glm::vec3(0)});
    odd.spheres.push_back({"huge", {{0, 0, -1e38f}, 1e38f}, 0, glm::vec3(0)});
    odd.cameras = {frontCamera(1.5f)};
    for (const SceneDescription& scene : {moving, odd})
        for (const TextureFilter filter :
             {TextureFilter::Nearest, TextureFilter::Bilinear, TextureFilter::Mipmap}) {
            const auto world = compileScene(scene, unlit(filter), 16, 16);
            for (int i = 0; i < 256; ++i) {
                const RgbSum value = pixelMean(*world, 0, i % 16, i / 16, 4);
                ASSERT_TRUE(math::isFinite(value));
                ASSERT_LE(value.x, 1.0);
            }
        }
}

TEST(SphereTexture, IsNotUsedWithoutTextureMapping) {
    SceneDescription scene = texturedSphere({{0, 0, 0}, 1.0f});
    scene.cameras = {pointCamera({0, 0, 3}, glm::vec3(0.0f))};
    Settings settings = unlit();
    settings.textureMapping = false;
    EXPECT_EQ(firstSample(*compileScene(scene, settings, 1, 1)), RgbSum(Rgb(0.3f)));
}

}  // namespace
}  // namespace rayscope::test
