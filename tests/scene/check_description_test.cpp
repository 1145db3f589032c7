#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/scene.h>

#include <functional>
#include <stdexcept>

#include "support/test_scenes.h"

namespace rayscope {
namespace {

using testing::HasSubstr;

struct Breakage {
    const char* name;
    std::function<void(SceneDescription&)> apply;
    const char* message;
};

std::shared_ptr<const Texture> textureOf(RgbImage image) {
    return std::make_shared<Texture>(Texture{"t", std::move(image)});
}

void editMesh(SceneDescription& scene, const std::function<void(MeshData&)>& edit) {
    auto data = std::make_shared<MeshData>(*scene.meshes[0].data);
    edit(*data);
    scene.meshes[0].data = data;
}

RgbImage tooFewPixels() {
    RgbImage image(2, 2);
    image.width = 4000;
    return image;
}

SceneDescription validScene() {
    SceneDescription scene;
    scene.materials = {test::material(Rgb(0.5f))};
    scene.meshes = {test::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0})};
    scene.spheres = {{"ball", {{0, 0, 0}, 1.0f}, 0, {}}};
    return scene;
}

const Breakage kBreakages[] = {
    {"null mesh", [](SceneDescription& s) { s.meshes[0].data = nullptr; }, "meshes[0]: data is null"},
    {"mesh without materials", [](SceneDescription& s) { s.meshes[0].materials.clear(); },
     "meshes[0]: materials is empty"},
    {"no materials", [](SceneDescription& s) { s.materials.clear(); }, "there are 0 materials"},
    {"material of a mesh", [](SceneDescription& s) { s.meshes[0].materials = {999}; }, "material index 999"},
    {"material of a sphere", [](SceneDescription& s) { s.spheres[0].material = 999; },
     "sphere 'ball': material index 999"},
    {"too few slots", [](SceneDescription& s) { editMesh(s, [](MeshData& m) { m.materialSlots = {0}; }); },
     "1 materialSlots for 2 triangles"},
    {"slot", [](SceneDescription& s) { editMesh(s, [](MeshData& m) {
                                           m.materialSlots = {0, 60000};
                                       }); },
     "material slot 60000"},
    {"vertex index", [](SceneDescription& s) { editMesh(s, [](MeshData& m) { m.triangles[1].z = 99; }); },
     "but there are 4 positions"},
    {"normals", [](SceneDescription& s) { editMesh(s, [](MeshData& m) { m.normals.resize(1); }); },
     "1 normals for 4 positions"},
    {"texture coordinates",
     [](SceneDescription& s) { editMesh(s, [](MeshData& m) { m.texCoords.resize(1); }); },
     "1 texCoords for 4 positions"},
    {"colors", [](SceneDescription& s) { editMesh(s, [](MeshData& m) { m.colors.resize(5); }); },
     "5 colors for 4 positions"},
    {"empty texture", [](SceneDescription& s) { s.materials[0].kdTexture = textureOf({}); }, "0 x 0 pixels"},
    {"texture", [](SceneDescription& s) { s.materials[0].kdTexture = textureOf(tooFewPixels()); },
     "4000 x 2 pixels with 4 stored"},
    {"empty environment", [](SceneDescription& s) { s.environment = std::make_shared<Environment>(); },
     "neither equirect nor all six faces"},
    {"one face",
     [](SceneDescription& s) {
         auto environment = std::make_shared<Environment>();
         environment->cube[0] = textureOf(RgbImage(2, 2));
         s.environment = environment;
     },
     "neither equirect nor all six faces"},
    {"empty equirect",
     [](SceneDescription& s) {
         auto environment = std::make_shared<Environment>();
         environment->equirect = textureOf({});
         s.environment = environment;
     },
     "environment.equirect: image of 0 x 0"},
};

std::string messageOf(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(CheckDescription, AcceptsValidScenes) {
    EXPECT_NO_THROW(checkDescription(validScene()));
    EXPECT_NO_THROW(checkDescription(SceneDescription{}));
}

TEST(CheckDescription, NamesWhatIsInvalid) {
    for (const Breakage& breakage : kBreakages) {
        SCOPED_TRACE(breakage.name);
        SceneDescription scene = validScene();
        breakage.apply(scene);
        EXPECT_THAT(messageOf([&] { checkDescription(scene); }), HasSubstr(breakage.message));
        EXPECT_THAT(messageOf([&] { lint(scene); }), HasSubstr(breakage.message));
        EXPECT_THAT(messageOf([&] { test::compileScene(scene, {}, 4, 4); }), HasSubstr(breakage.message));
    }
}

TEST(CheckDescription, BoundsAndRequirementsNeedMeshData) {
    SceneDescription scene = validScene();
    scene.meshes[0].data = nullptr;
    EXPECT_THAT(messageOf([&] { boundsOf(scene); }), HasSubstr("data is null"));
    EXPECT_THAT(messageOf([&] { requirementsOf(scene); }), HasSubstr("data is null"));
}

/// Meshes of the previous world are not checked again, unless they are used with fewer materials.
TEST(CheckDescription, RecompilingChecksWhatIsNew) {
    SceneDescription scene = validScene();
    editMesh(scene, [](MeshData& m) { m.materialSlots = {0, 1}; });
    scene.materials.push_back(test::material(Rgb(0.1f)));
    scene.meshes[0].materials = {0, 1};
    const auto world = test::compileScene(scene, {}, 4, 4);
    scene.meshes[0].materials = {0};
    const auto changed = std::make_shared<const SceneDescription>(scene);
    EXPECT_THAT(messageOf([&] {
                    trace::compile({changed, {}, CameraDescription{}, 4, 4}, world.get());
                }),
                HasSubstr("material slot 1"));
}

}  // namespace
}  // namespace rayscope
