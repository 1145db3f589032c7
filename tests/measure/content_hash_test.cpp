#include "measure/trade/content_hash.h"

#include <gtest/gtest.h>

#include <functional>

#include "support/test_scenes.h"

namespace rayscope {
namespace {

struct Subject {
    SceneDescription scene;
    Settings settings;
    int width = 16, height = 12;
    std::string hash() const {
        const trace::CompileRequest request{std::make_shared<const SceneDescription>(scene), settings,
                                            scene.cameras.front(), width, height};
        return measure::filmContentHash(request, *trace::compile(request));
    }
};

Subject subject() {
    Subject s;
    s.scene.cameras = {test::frontCamera(3.0f)};
    s.scene.meshes = {test::quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0})};
    s.scene.spheres = {{"s", {{0, 0, 1}, 0.3f}, 0, glm::vec3(0.0f)}};
    s.scene.materials = {test::material(Rgb(0.5f), Rgb(0.1f), 3.0f)};
    s.scene.lights = {test::pointLight({0, 1, 3})};
    return s;
}

TEST(FilmContentHash, DependsOnlyOnTheContent) {
    EXPECT_EQ(subject().hash(), subject().hash());
    EXPECT_EQ(subject().hash().size(), 32u);
    Subject renamed = subject();
    renamed.scene.path = "elsewhere.toml";
    renamed.scene.meshes[0].name = renamed.scene.materials[0].name = "other";
    EXPECT_EQ(renamed.hash(), subject().hash());
    Subject faster = subject();
    faster.settings.bvhBuilder = BvhBuilder::Median;
    faster.settings.exposure = 2.0f;
    faster.settings.spp = 99;
    EXPECT_EQ(faster.hash(), subject().hash()) << "none of them changes a sample";
}

TEST(FilmContentHash, ChangesWithEveryInputOfTheFilm) {
    const std::pair<const char*, std::function<void(Subject&)>> changes[] = {
        {"vertex",
         [](Subject& s) {
             s.scene.meshes[0] = test::quad({-1, -1, 0}, {2, 0, 0}, {0, 2.000001f, 0});
         }},
        {"transform", [](Subject& s) { s.scene.meshes[0].transform.rotate.x = 1e-3f; }},
        {"mesh motion", [](Subject& s) { s.scene.meshes[0].motion.x = 0.1f; }},
        {"sphere", [](Subject& s) { s.scene.spheres[0].sphere.radius = 0.31f; }},
        {"no sphere", [](Subject& s) { s.scene.spheres.clear(); }},
        {"kd", [](Subject& s) { s.scene.materials[0].kd.y = 0.50001f; }},
        {"shininess", [](Subject& s) { s.scene.materials[0].shininess = 4.0f; }},
        {"opacity", [](Subject& s) { s.scene.materials[0].opacity = 0.5f; }},
        {"texture",
         [](Subject& s) {
             Texture texture;
             texture.image = RgbImage(2, 2, Rgb(0.3f));
             s.scene.materials[0].kdTexture = std::make_shared<const Texture>(texture);
         }},
        {"light", [](Subject& s) { std::get<PointLight>(s.scene.lights[0].shape).color.z = 0.9f; }},
        {"falloff", [](Subject& s) { s.scene.lights[0].falloff = Falloff::InverseSquare; }},
        {"fov", [](Subject& s) { s.scene.cameras[0].fov = 51.0f; }},
        {"lens", [](Subject& s) { s.scene.cameras[0].lens = Lens{}; }},
        {"size", [](Subject& s) { s.width = 17; }},
        {"setting", [](Subject& s) { s.settings.maxDepth = 3; }},
        {"sampler", [](Subject& s) { s.settings.sampler = SamplePattern::Independent; }}};
    for (const auto& [what, change] : changes) {
        Subject changedSubject = subject();
        change(changedSubject);
        EXPECT_NE(changedSubject.hash(), subject().hash()) << what;
    }
}

}  // namespace
}  // namespace rayscope
