// Saved scenes read back as the same bits, and what was not edited keeps its text.
#include <rayscope/save_scene.h>
#include <rayscope/settings.h>

#include <bit>
#include <cmath>
#include <map>
#include <random>

#include "scene_files.h"

namespace rayscope {
namespace {

using SaveScene = test::SceneFiles;

constexpr std::string_view kScene = R"(# My scene, ü.
version = 1

[[camera]]   # the only one
look_from = [0, 0, 3.0]  # in front

[camera.lens]
f_number = 2.8

[[light]]
type = "point"
position = [1, 2, 3]
color = { srgb = [0.5, 0.5, 0.5] }  # grey

# The second light.
[[light]]
type = "segment"
endpoints = [
  [0, 1, 0],
  [1, 1, 0],  # end
]

[settings]
exposure = 0.50  # half
tone = 'srgb'

[[sphere]]
center = [0, 0, 0]
radius = 1
)";

/// All floats of lights and cameras as bits.
std::vector<std::uint32_t> bitsOf(const SceneDescription& scene) {
    std::vector<std::uint32_t> bits;
    const auto add = [&](float x) { bits.push_back(std::bit_cast<std::uint32_t>(x)); };
    const auto addVector = [&](const glm::vec3& v) { add(v.x), add(v.y), add(v.z); };
    for (const CameraDescription& camera : scene.cameras) {
        for (const glm::vec3& v : {camera.lookFrom, camera.lookAt, camera.up}) addVector(v);
        add(camera.fov);
        const Lens lens = camera.lens.value_or(Lens{-1.0f, -1.0f, -1.0f});
        for (const float x : {lens.fNumber, lens.focalLength, lens.focusDistance}) add(x);
    }
    for (const Light& light : scene.lights) {
        bits.push_back(static_cast<std::uint32_t>(light.shape.index()));
        bits.push_back(static_cast<std::uint32_t>(light.falloff));
        if (const auto* point = std::get_if<PointLight>(&light.shape))
            for (const glm::vec3& v : {point->position, point->color}) addVector(v);
        if (const auto* segment = std::get_if<SegmentLight>(&light.shape)) {
            for (const glm::vec3& v : segment->endpoints) addVector(v);
            for (const Rgb& v : segment->colors) addVector(v);
        }
        if (const auto* area = std::get_if<ParallelogramLight>(&light.shape)) {
            for (const glm::vec3& v : {area->corner, area->edges[0], area->edges[1]}) addVector(v);
            for (const Rgb& v : area->colors) addVector(v);
        }
    }
    return bits;
}

std::map<std::string, std::string> settingsOf(const SceneDescription& scene) {
    std::map<std::string, std::string> values;
    for (const SettingAssignment& setting : scene.settings) values[setting.key] = setting.value;
    return values;
}

/// Edits scenes as the window can: lights, cameras and settings.
class RandomEdits {
  public:
    explicit RandomEdits(unsigned seed) : random_(seed) {}

    void apply(SceneDescription& scene) {
        std::vector<Light>& lights = scene.lights;
        const std::size_t kind = below(6);
        if (kind == 0 || lights.empty()) {
            lights.push_back(light());
        } else if (kind == 1) {
            lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(below(lights.size())));
        } else if (kind == 2) {
            lights[below(lights.size())] = light();
        } else if (kind == 3) {
            CameraDescription& camera = scene.cameras[below(scene.cameras.size())];
            camera.lookFrom = {4.0f + fraction(), 1.0f + fraction(), 5.0f + fraction()};
            camera.fov = 1.0f + 100.0f * fraction();
        } else if (kind == 4) {
            CameraDescription& camera = scene.cameras[below(scene.cameras.size())];
            if (camera.lens && below(2) == 0)
                camera.lens.reset();
            else
                camera.lens = Lens{1.0f + fraction(), 0.01f + fraction(), 1.0f + fraction()};
        } else {
            setExposure(scene);
        }
    }

  private:
    std::size_t below(std::size_t n) { return random_() % n; }
    float fraction() { return static_cast<float>(random_() >> 8) * 0x1p-24f; }
    float any() {
        const float x = std::ldexp(fraction() - 0.5f, static_cast<int>(below(40)) - 20);
        return below(20) == 0 ? -0.0f : x;
    }
    glm::vec3 vector() { return {any(), any(), any()}; }
    Rgb color() { return {fraction(), fraction(), 2.0f * fraction()}; }
    Light light() {
        Light light;
        if (below(3) == 0)
            light.shape = PointLight{vector(), color()};
        else if (below(2) == 0)
            light.shape = SegmentLight{{vector(), vector()}, {color(), color()}};
        else
            light.shape =
                ParallelogramLight{vector(), {vector(), vector()}, {color(), color(), color(), color()}};
        if (below(3) == 0) light.falloff = Falloff::InverseSquare;
        return light;
    }
    void setExposure(SceneDescription& scene) {
        Settings settings;
        assign(settings, "exposure", std::to_string(fraction()));
        std::erase_if(scene.settings, [](const SettingAssignment& s) { return s.key == "exposure"; });
        scene.settings.push_back({"exposure", textOf(settings, "exposure"), {}});
    }

    std::mt19937 random_;
};

TEST_F(SaveScene, KeepsTheTextOfAnUneditedScene) {
    const std::string path = write("scene.toml", kScene);
    EXPECT_EQ(savedSceneText(load(path), path), kScene);
}

TEST_F(SaveScene, ChangesNothingButTheEditedValues) {
    const std::string path = write("scene.toml", kScene);
    SceneDescription scene = load(path);
    std::get<PointLight>(scene.lights[0].shape).position.y = 2.5f;
    std::string expected(kScene);
    expected.replace(expected.find("[1, 2, 3]"), 9, "[1, 2.5, 3]");
    EXPECT_EQ(savedSceneText(scene, path), expected);
}

TEST_F(SaveScene, ReadsBackAsTheSameBitsAfterRandomEdits) {
    const std::string own = write("scene.toml", kScene), saved = (folder_ / "other" / "saved.toml").string();
    write("other/placeholder", "");
    for (const std::string& path : {own, std::string("builtin:cornell"), std::string("builtin:spheres-dof"),
                                    std::string("builtin:quad-textured")}) {
        RandomEdits edits(7);
        SceneDescription scene = load(path);
        for (int round = 0; round < 60; ++round) {
            edits.apply(scene);
            saveScene(scene, saved);
            SceneDescription read = load(saved);
            ASSERT_EQ(bitsOf(read), bitsOf(scene)) << path << ", round " << round;
            ASSERT_EQ(settingsOf(read), settingsOf(scene)) << path << ", round " << round;
            ASSERT_EQ(read.meshes.size(), scene.meshes.size());
            ASSERT_EQ(read.materials.size(), scene.materials.size());
            if (round % 3 == 0) scene = std::move(read);  // edits of a text that was edited
        }
    }
}

TEST_F(SaveScene, RefersToTheSameFilesFromAnotherFolder) {
    write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string path =
        write("scene.toml", "version = 1\n[[mesh]]\nfile = \"mesh.obj\"  # a triangle\n");
    write("other/placeholder", "");
    const std::string saved = (folder_ / "other" / "saved.toml").string();
    saveScene(load(path), saved);
    const SceneDescription read = load(saved);
    ASSERT_EQ(read.meshes.size(), 1u);
    EXPECT_EQ(read.meshes[0].data->triangles.size(), 1u);
}

TEST_F(SaveScene, MakesASceneOfAMesh) {
    const std::string path = write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string saved = (folder_ / "saved.toml").string();
    const SceneDescription scene = load(path);
    saveScene(scene, saved);
    const SceneDescription read = load(saved);
    EXPECT_EQ(bitsOf(read), bitsOf(scene));
    EXPECT_EQ(read.meshes.size(), 1u);
}

TEST_F(SaveScene, RefusesATextThatItCannotChange) {
    const std::string path = write("scene.toml",
                                   "version = 1\nsettings.exposure = 1.0\n[[sphere]]\ncenter = [0, 0, 0]\n"
                                   "radius = 1\n");
    SceneDescription scene = load(path);
    scene.settings.push_back({"spp", "4", {}});
    EXPECT_THROW(savedSceneText(scene, path), InputError);
}

}  // namespace
}  // namespace rayscope
