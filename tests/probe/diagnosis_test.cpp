// Scenes with a planted defect; diagnoses are counted as right, wrong or unknown. None may be wrong.
#include "probe/diagnosis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/test_scenes.h"

namespace rayscope {
namespace {

/// Over the pixels that show the symptom.
struct Score {
    int right = 0, wrong = 0, unknown = 0;
};

Score diagnosisScore(const trace::World& world, probe::Symptom symptom, std::vector<probe::Cause> accepted,
                     int samples = 8) {
    Score score;
    for (int y = 0; y < world.height; ++y)
        for (int x = 0; x < world.width; ++x)
            for (const probe::Diagnosis& diagnosis : probe::diagnosePixel(world, 1, x, y, samples)) {
                if (diagnosis.symptom != symptom) continue;
                EXPECT_FALSE(diagnosis.sentence.empty());
                const bool right =
                    std::find(accepted.begin(), accepted.end(), diagnosis.cause) != accepted.end();
                ++(right                                      ? score.right
                   : diagnosis.cause == probe::Cause::Unknown ? score.unknown
                                                              : score.wrong);
                for (const probe::Evidence& evidence : diagnosis.evidence)
                    EXPECT_LT(evidence.sample, samples);
            }
    std::printf("right %d, wrong %d, unknown %d\n", score.right, score.wrong, score.unknown);
    return score;
}

/// A wall that fills the picture, seen from the front, with a light beside the camera.
SceneDescription wall() {
    SceneDescription scene;
    scene.materials = {test::material(Rgb(0.8f))};
    scene.meshes = {test::quad({-9, -9, 0}, {18, 0, 0}, {0, 18, 0})};
    scene.lights = {test::pointLight({0.5f, 1.0f, 2.5f})};
    return scene;
}

std::shared_ptr<const trace::World> compiled(SceneDescription scene, Settings settings = {}, int size = 12) {
    return test::compileScene(std::move(scene), settings, size, size);
}

/// The same quad with these vertex normals.
void setNormals(SceneDescription& scene, std::vector<glm::vec3> normals) {
    auto data = std::make_shared<MeshData>(*scene.meshes[0].data);
    data->normals = std::move(normals);
    scene.meshes[0].data = data;
}

TEST(Diagnosis, OrdinaryPixelHasNone) {
    const auto world = compiled(wall());
    for (int i = 0; i < 12; ++i) EXPECT_TRUE(probe::diagnosePixel(*world, 1, i, 6, 8).empty());
}

TEST(Diagnosis, MissingLight) {
    SceneDescription scene = wall();
    scene.lights.clear();
    const Score score = diagnosisScore(*compiled(scene), probe::Symptom::Black, {probe::Cause::NoLight});
    EXPECT_EQ(score.right, 144);
    EXPECT_EQ(score.wrong, 0);
}

TEST(Diagnosis, OccludedLight) {
    SceneDescription scene = wall();
    scene.meshes.push_back(test::quad({-0.5f, 0.0f, 2.2f}, {2, 0, 0}, {0, 2, 0}));
    scene.meshes[1].name = "lid";
    scene.cameras = {test::frontCamera(2.0f)};
    const auto world = compiled(scene);
    const Score score = diagnosisScore(*world, probe::Symptom::Black, {probe::Cause::LightOccluded});
    EXPECT_GT(score.right, 100);
    EXPECT_EQ(score.wrong, 0);
    EXPECT_NE(probe::diagnosePixel(*world, 1, 6, 4, 4).front().sentence.find("lid"), std::string::npos)
        << "names the occluder";
}

TEST(Diagnosis, LightBehindSurface) {
    SceneDescription scene = wall();
    scene.lights = {test::pointLight({0, 0, -2})};
    const Score score =
        diagnosisScore(*compiled(scene), probe::Symptom::Black, {probe::Cause::LightBehindSurface});
    EXPECT_EQ(score.right, 144);
}

TEST(Diagnosis, BlackMaterialAndEmptyScene) {
    SceneDescription scene = wall();
    scene.materials = {test::material(Rgb(0.0f))};
    EXPECT_EQ(diagnosisScore(*compiled(scene), probe::Symptom::Black, {probe::Cause::BlackMaterial}).right,
              144);
    EXPECT_EQ(diagnosisScore(*compiled({}), probe::Symptom::Black, {probe::Cause::NothingHit}).right, 144);
}

TEST(Diagnosis, DeviatingNormals) {
    SceneDescription scene = wall();
    // Two corners are flipped: between them and the others the normals turn away from the light.
    setNormals(scene, {{1, 0, 0.05f}, {1, 0, 0.05f}, {1, 0, 0.05f}, {1, 0, 0.05f}});
    scene.lights = {test::pointLight({-2.5f, 0, 0.1f})};
    const Score score = diagnosisScore(*compiled(scene), probe::Symptom::Black, {probe::Cause::BadNormal});
    EXPECT_GT(score.right, 100);
    EXPECT_EQ(score.wrong, 0);
}

TEST(Diagnosis, SmallBrightSourceInGlossyReflection) {
    SceneDescription scene;
    scene.materials = {test::material(Rgb(0.02f), Rgb(0.8f), 8.0f), test::material(Rgb(1.0f))};
    scene.meshes = {test::quad({-9, -9, 0}, {18, 0, 0}, {0, 18, 0})};
    SphereInstance bulb;
    bulb.sphere = {{0.0f, 0.0f, 4.0f}, 0.3f};
    bulb.material = 1;
    scene.spheres = {bulb};
    // Close to the bulb and dim elsewhere: only reflected rays hit something bright.
    scene.lights = {Light{PointLight{{0.0f, 0.0f, 3.6f}, Rgb(0.3f)}, Falloff::InverseSquare}};
    Settings settings;
    settings.glossy = true;
    settings.glossySamples = 1;
    settings.glossySigma = 3.0f;
    scene.cameras = {test::frontCamera(3.0f)};
    const Score score = diagnosisScore(*compiled(scene, settings), probe::Symptom::Noisy,
                                       {probe::Cause::RareBrightPaths, probe::Cause::GlossyReflection}, 64);
    EXPECT_GT(score.right, 5);
    EXPECT_EQ(score.wrong, 0);
}

TEST(Diagnosis, PenumbraWithFewSamples) {
    SceneDescription scene = wall();
    scene.lights = {
        Light{ParallelogramLight{
                  {-1, -1, 2.5f}, {glm::vec3(2, 0, 0), glm::vec3(0, 2, 0)}, {Rgb(1), Rgb(1), Rgb(1), Rgb(1)}},
              Falloff::None}};
    scene.meshes.push_back(test::quad({-0.4f, -0.4f, 1.0f}, {0.8f, 0, 0}, {0, 0.8f, 0}));
    CameraDescription camera;
    camera.lookFrom = {0, -3, 0.6f};
    camera.lookAt = {0, 0, 0};
    camera.up = {0, 0, 1};
    scene.cameras = {camera};
    Settings settings;
    settings.parallelogramSamples = 1;
    const Score score = diagnosisScore(*compiled(scene, settings, 16), probe::Symptom::Noisy,
                                       {probe::Cause::Penumbra, probe::Cause::Edge}, 16);
    EXPECT_GT(score.right, 10);
    EXPECT_EQ(score.wrong, 0);
}

/// A small object on an empty background: most pixels of the image see nothing, and that is no measure of a
/// ray that hits the object.
TEST(Diagnosis, OrdinaryPixelsOfASmallObjectAreNotSlow) {
    SceneDescription scene;
    scene.materials = {test::material(Rgb(0.8f))};
    for (int i = 0; i < 4096; ++i) {
        const float x = -0.4f + 0.0125f * static_cast<float>(i % 64),
                    y = -0.4f + 0.0125f * static_cast<float>(i / 64);
        scene.meshes.push_back(test::quad({x, y, 0}, {0.0125f, 0, 0}, {0, 0.0125f, 0}));
    }
    scene.lights = {test::pointLight({0.5f, 1.0f, 2.5f})};
    const auto world = compiled(scene, {}, 40);
    int hits = 0;
    for (int y = 0; y < 40; y += 3)
        for (int x = 0; x < 40; x += 3) {
            hits += probeSample(*world, 1, {x, y, 0}).nodes.front().hit ? 1 : 0;
            for (const probe::Diagnosis& why : probe::diagnosePixel(*world, 1, x, y, 4))
                EXPECT_NE(why.symptom, probe::Symptom::Slow) << x << " " << y << " " << why.sentence;
        }
    EXPECT_GT(hits, 5);
}

/// Two walls of one object and one material behind one another: the pixels along the nearer edge are noisy,
/// because their samples see both.
TEST(Diagnosis, SilhouetteOfAnObjectInFrontOfItself) {
    SceneDescription scene;
    scene.materials = {test::material(Rgb(0.8f))};
    auto data = std::make_shared<MeshData>();
    data->positions = {{-9, -9, 0}, {9, -9, 0},     {9, 9, 0},     {-9, 9, 0},
                       {-9, -9, 2}, {0.05f, -9, 2}, {0.05f, 9, 2}, {-9, 9, 2}};
    data->triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
    scene.meshes = {{"walls", data, {}, {0}, glm::vec3(0.0f)}};
    scene.lights = {test::pointLight({2.0f, 0.0f, 1.0f}), test::pointLight({-0.5f, 0.0f, 2.2f}, Rgb(0.2f))};
    Settings settings;
    settings.hardShadows = false;
    const Score score =
        diagnosisScore(*compiled(scene, settings), probe::Symptom::Noisy, {probe::Cause::Edge});
    EXPECT_GT(score.right, 3);
    EXPECT_EQ(score.wrong, 0);
    EXPECT_EQ(score.unknown, 0);
}

TEST(Diagnosis, DuplicateGeometry) {
    // Two thousand copies of a triangle in the middle, beside a wall that takes few intersection tests.
    SceneDescription scene = wall();
    auto copies = std::make_shared<MeshData>();
    copies->positions = {{-0.4f, -0.4f, 0.5f}, {0.5f, -0.4f, 0.5f}, {0.0f, 0.5f, 0.5f}};
    copies->triangles.assign(2000, glm::uvec3(0, 1, 2));
    scene.meshes.push_back({"copies", copies, {}, {0}, glm::vec3(0.0f)});
    const Score score =
        diagnosisScore(*compiled(scene), probe::Symptom::Slow, {probe::Cause::DuplicateGeometry}, 2);
    EXPECT_GT(score.right, 3);
    EXPECT_EQ(score.wrong, 0);
}

TEST(Diagnosis, Overflow) {
    SceneDescription scene = wall();
    scene.lights = {test::pointLight({0, 0, 2.5f}, Rgb(3e38f)), test::pointLight({0, 0, 2.5f}, Rgb(3e38f))};
    scene.materials = {test::material(Rgb(1.0f))};
    const Score score = diagnosisScore(*compiled(scene), probe::Symptom::NonFinite, {probe::Cause::Overflow});
    EXPECT_GT(score.right, 50);
    EXPECT_EQ(score.wrong, 0);
}

TEST(Diagnosis, NaNNormal) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    SceneDescription scene = wall();
    setNormals(scene, {{nan, 0, 1}, {nan, 0, 1}, {nan, 0, 1}, {nan, 0, 1}});
    // The tracer falls back to the geometric normal, so the pixel is correct.
    const auto world = compiled(scene);
    EXPECT_TRUE(probe::diagnosePixel(*world, 1, 6, 6, 4).empty());
}

TEST(Diagnosis, BrightLight) {
    SceneDescription scene = wall();
    scene.lights.push_back(test::pointLight({0, 0, 2}, Rgb(40.0f)));
    const auto world = compiled(scene);
    const Score score = diagnosisScore(*world, probe::Symptom::Bright, {probe::Cause::StrongLight});
    EXPECT_EQ(score.right, 144);
    EXPECT_NE(probe::diagnosePixel(*world, 1, 6, 6, 4).front().sentence.find("Light 1"), std::string::npos);
}

}  // namespace
}  // namespace rayscope
