// The reader of scene files: every key, and position and message of each kind of error.
#include <rayscope/settings.h>

#include <algorithm>
#include <sstream>

#include "scene_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class TomlScene : public SceneFiles {
  protected:
    SceneDescription read(const std::string& body) {
        return load(write("scene.toml", "version = 1\n" + body));
    }
    /// `body` begins on line 2.
    std::string failure(const std::string& body) {
        return errorOf(write("scene.toml", "version = 1\n" + body));
    }
};

TEST_F(TomlScene, ReadsCameras) {
    const auto scene = read(R"(
[[camera]]
name = "close"
look_from = [1, 2, 3]
look_at = [0.5, 0, 0]
up = [0, 0, 1]
fov = 30
lens = { f_number = 4, focal_length = 0.1, focus_distance = 2 }
[[camera]]
look_from = [0, 0, 9]
)");
    ASSERT_EQ(scene.cameras.size(), 2u);
    const CameraDescription& camera = scene.cameras[0];
    EXPECT_EQ(camera.name, "close");
    EXPECT_EQ(camera.lookFrom, glm::vec3(1, 2, 3));
    EXPECT_EQ(camera.lookAt, glm::vec3(0.5f, 0, 0));
    EXPECT_EQ(camera.up, glm::vec3(0, 0, 1));
    EXPECT_EQ(camera.fov, 30.0f);
    ASSERT_TRUE(camera.lens);
    EXPECT_EQ(*camera.lens, (Lens{4.0f, 0.1f, 2.0f}));
    EXPECT_EQ(scene.cameras[1].name, "camera 2");
    EXPECT_FALSE(scene.cameras[1].lens);
}

TEST_F(TomlScene, ReadsLights) {
    const auto scene = read(R"(
[[light]]
type = "point"
position = [0, 1, 0]
color = [15, 15, 15]
falloff = "inverse_square"
[[light]]
type = "segment"
endpoints = [[1, 0, 0], [2, 0, 0]]
colors = [[1, 0, 0], [0, 1, 0]]
[[light]]
type = "parallelogram"
corner = [1, 1, 1]
edges = [[1, 0, 0], [0, 0, 2]]
colors = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 1, 1]]
)");
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(scene.lights[0], (Light{PointLight{{0, 1, 0}, Rgb(15.0f)}, Falloff::InverseSquare}));
    EXPECT_EQ(scene.lights[1],
              (Light{SegmentLight{{glm::vec3(1, 0, 0), glm::vec3(2, 0, 0)}, {Rgb(1, 0, 0), Rgb(0, 1, 0)}}}));
    const auto& area = std::get<ParallelogramLight>(scene.lights[2].shape);
    EXPECT_EQ(area.corner, glm::vec3(1));
    EXPECT_EQ(area.edges[1], glm::vec3(0, 0, 2));
    EXPECT_EQ(area.colors[3], Rgb(0, 1, 1));
}

TEST_F(TomlScene, ReadsMaterialsMeshesAndSpheres) {
    const auto scene = read(R"(
[material.gold]
kd = [0.5, 0.4, 0.1]
ks = { srgb = [1, 1, 0] }
shininess = 40
opacity = 0.25
illum = 3
kd_texture = { generate = "texels", size = [2, 1], colors = [[1, 0, 0], [0, 0, 1]], wrap = "clamp" }
[[mesh]]
name = "box"
generate = { shape = "box", size = [1, 2, 3] }
transform = { scale = 2, rotate = [0, 90, 0], translate = [1, 0, 0] }
motion = [0, 0.5, 0]
material = "gold"
[[sphere]]
name = "ball"
center = [0, 1, 0]
radius = 0.5
material = "gold"
motion = [1, 0, 0]
)");
    ASSERT_EQ(scene.materials.size(), 1u);
    const Material& gold = scene.materials[0];
    EXPECT_EQ(gold.kd, Rgb(0.5f, 0.4f, 0.1f));
    EXPECT_EQ(gold.ks, Rgb(1, 1, 0));
    EXPECT_EQ(gold.shininess, 40.0f);
    EXPECT_EQ(gold.opacity, 0.25f);
    EXPECT_EQ(gold.illum, 3);
    ASSERT_TRUE(gold.kdTexture);
    EXPECT_EQ(gold.kdTexture->wrap, TextureWrap::Clamp);
    EXPECT_EQ(gold.kdTexture->image.at(1, 0), Rgb(0, 0, 1));
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].data->triangles.size(), 12u);
    EXPECT_EQ(scene.meshes[0].motion, glm::vec3(0, 0.5f, 0));
    EXPECT_EQ(scene.meshes[0].transform.rotate, glm::vec3(0, 90, 0));
    ASSERT_EQ(scene.spheres.size(), 1u);
    EXPECT_EQ(scene.spheres[0].sphere.radius, 0.5f);
    EXPECT_EQ(scene.spheres[0].motion, glm::vec3(1, 0, 0));
}

TEST_F(TomlScene, DecodesSrgbColours) {
    const auto scene = read("[material.a]\nkd = { srgb = [0.5, 0.04045, 1] }\n");
    EXPECT_NEAR(scene.materials[0].kd.r, 0.21404114, 1e-6);
    EXPECT_NEAR(scene.materials[0].kd.g, 0.04045 / 12.92, 1e-7);
    EXPECT_EQ(scene.materials[0].kd.b, 1.0f);
}

TEST_F(TomlScene, MatrixIsRowMajor) {
    const auto scene = read(
        "[[mesh]]\ngenerate = { shape = \"quad\" }\n"
        "transform = { matrix = [1, 0, 0, 5,  0, 2, 0, 6,  0, 0, 3, 7,  0, 0, 0, 1] }\n");
    const glm::dvec4 moved = matrixOf(scene.meshes[0].transform) * glm::dvec4(1, 1, 1, 1);
    EXPECT_EQ(moved, glm::dvec4(6, 8, 10, 1));
}

TEST_F(TomlScene, KeepsSettingsWithTheirPosition) {
    const auto scene = read("[settings]\nspp = 64\nglossy = true\nsampler = \"jittered\"\n");
    ASSERT_EQ(scene.settings.size(), 3u);
    for (const SettingAssignment& setting : scene.settings) {
        Settings settings;
        EXPECT_NO_THROW(assign(settings, setting.key, setting.value));
        EXPECT_GE(setting.position.line, 3);
    }
}

TEST_F(TomlScene, MissingCameraAndLightsAreWarnings) {
    const auto scene = read("[[sphere]]\ncenter = [5, 0, 0]\nradius = 1\n");
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].lookAt, glm::vec3(5, 0, 0));
    EXPECT_EQ(notes_.size(), 2u);
    EXPECT_THAT(notesText(), HasSubstr("warning: no camera"));
    EXPECT_THAT(notesText(), HasSubstr("warning: no light"));
}

TEST_F(TomlScene, InstancesOfAFileShareItsData) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto scene = read("[[mesh]]\nfile = \"a.obj\"\n[[mesh]]\nfile = \"./a.obj\"\n");
    EXPECT_EQ(scene.meshes[0].data, scene.meshes[1].data);
    EXPECT_EQ(scene.materials.size(), 1u);
}

struct WrongScene {
    const char* name;
    const char* body;  ///< begins on line 2
    const char* error;
};
void PrintTo(const WrongScene& wrong, std::ostream* out) { *out << wrong.name; }

class WrongToml : public TomlScene, public ::testing::WithParamInterface<WrongScene> {};

TEST_P(WrongToml, IsAnErrorWithItsPosition) {
    EXPECT_THAT(failure(GetParam().body), StartsWith(GetParam().error));
}

const WrongScene kWrongScenes[] = {
    {"UnknownTable", "[[spere]]\n",
     "scene.toml:2:3: error: unknown key 'spere' in a scene (did you mean 'sphere'?)"},
    {"UnknownKey", "[[sphere]]\ncentre = [0, 0, 0]\n",
     "scene.toml:3:1: error: unknown key 'centre' in a sphere (did you mean 'center'?); expected name, "
     "center, radius"},
    {"KeyOfAnotherLight", "[[light]]\ntype = \"segment\"\nposition = [0, 0, 0]\n",
     "scene.toml:4:1: error: unknown key 'position' in a segment light; expected type, falloff, endpoints or "
     "colors"},
    {"UnknownLight", "[[light]]\ntype = \"sun\"\n",
     "scene.toml:3:8: error: type: expected point, segment or parallelogram, got 'sun'"},
    {"LightWithoutType", "[[light]]\n", "scene.toml:2:1: error: light: needs the key 'type'"},
    {"MissingKey", "[[sphere]]\ncenter = [0, 0, 0]\n",
     "scene.toml:2:1: error: a sphere needs the key 'radius'"},
    {"WrongType", "[[sphere]]\ncenter = [0, 0, 0]\nradius = \"big\"\n",
     "scene.toml:4:10: error: radius: expected a number above 0, got a string"},
    {"OutOfRange", "[[sphere]]\ncenter = [0, 0, 0]\nradius = -1\n",
     "scene.toml:4:10: error: radius: expected a number above 0, got -1"},
    {"OpenRange", "[[camera]]\nlook_from = [0, 0, 1]\nfov = 180\n",
     "scene.toml:4:7: error: fov: expected a number above 0 and below 180, got 180"},
    {"Fraction", "[material.a]\nopacity = 1.5\n",
     "scene.toml:3:11: error: opacity: expected a number from 0 to 1, got 1.5"},
    {"NotANumber", "[[sphere]]\ncenter = [0, nan, 0]\nradius = 1\n",
     "scene.toml:3:14: error: center: expected a finite number, got nan"},
    {"Infinite", "[[sphere]]\ncenter = [0, 0, 0]\nradius = inf\n",
     "scene.toml:4:10: error: radius: expected a finite number, got inf"},
    {"TooLargeForFloat", "[[sphere]]\ncenter = [0, 1e39, 0]\nradius = 1\n",
     "scene.toml:3:14: error: center: expected a number, got 1e+39"},
    {"TooSmallForFloat", "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1e-60\n",
     "scene.toml:4:10: error: radius: expected a number above 0, got 1e-60"},
    {"WrongLength", "[[sphere]]\ncenter = [0, 0]\nradius = 1\n",
     "scene.toml:3:10: error: center: expected an array of 3 numbers, got 2 elements"},
    {"WrongElement", "[[sphere]]\ncenter = [0, true, 0]\nradius = 1\n",
     "scene.toml:3:14: error: center: expected a number, got a boolean"},
    {"Colour", "[material.a]\nkd = { rgb = [1, 1, 1] }\n",
     "scene.toml:3:6: error: kd: expected a colour: [r, g, b] or { srgb = [r, g, b] }"},
    {"SingleBracket", "[camera]\nlook_from = [0, 0, 1]\n",
     "scene.toml:2:1: error: camera: expected an array of tables; write [[camera]]"},
    {"UndefinedMaterial",
     "[material.gold]\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"glod\"\n",
     "scene.toml:6:12: error: undefined material 'glod' (did you mean 'gold'?); expected gold"},
    {"NoMaterials", "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"gold\"\n",
     "scene.toml:5:12: error: undefined material 'gold'; the scene defines no material"},
    {"DuplicateMaterial", "[material.a]\n[material.a]\n", "scene.toml:3:"},
    {"DuplicateCamera",
     "[[camera]]\nlook_from = [0, 0, 1]\n[[camera]]\nname = \"main\"\nlook_from = [0, 0, 1]\n",
     "scene.toml:4:1: error: camera: duplicate camera name 'main'"},
    {"NoView", "[[camera]]\nlook_from = [1, 1, 1]\nlook_at = [1, 1, 1]\n",
     "scene.toml:2:1: error: camera: look_from and look_at are the same point"},
    {"UpAlongTheView", "[[camera]]\nlook_from = [0, 5, 0]\n",
     "scene.toml:2:1: error: camera: up is parallel to the viewing direction"},
    {"MeshOfNothing", "[[mesh]]\nname = \"a\"\n", "scene.toml:2:1: error: mesh: needs either file"},
    {"MissingMesh", "[[mesh]]\nfile = \"gone.obj\"\nif_missing = \"make it\"\n",
     "scene.toml:3:8: error: mesh file not found: gone.obj; make it"},
    {"MissingImage", "[material.a]\nkd_texture = \"gone.png\"\n",
     "scene.toml:3:14: error: image file not found: gone.png"},
    {"UnknownShape", "[[mesh]]\ngenerate = { shape = \"teapt\" }\n",
     "scene.toml:3:22: error: shape: expected quad, "},
    {"KeyOfAnotherShape", "[[mesh]]\ngenerate = { shape = \"quad\", radius = 2 }\n",
     "scene.toml:3:30: error: unknown key 'radius' in the shape 'quad'; expected shape or size"},
    {"Integer", "[[mesh]]\ngenerate = { shape = \"teapot\", resolution = 1.5 }\n",
     "scene.toml:3:45: error: resolution: expected an integer from 1 to 512, got a number"},
    {"SingularMatrix",
     "[[mesh]]\ngenerate = { shape = \"quad\" }\n"
     "transform = { matrix = [1,0,0,0, 0,1,0,0, 0,0,0,0, 0,0,0,1] }\n",
     "scene.toml:4:24: error: matrix: singular matrix"},
    {"MatrixAndMore",
     "[[mesh]]\ngenerate = { shape = \"quad\" }\n"
     "transform = { scale = 2, matrix = [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1] }\n",
     "scene.toml:4:13: error: transform: matrix excludes the other keys"},
    {"EmptyEnvironment", "[environment]\n",
     "scene.toml:2:1: error: environment: needs one of cube, equirect and generate"},
    {"HalfACube", "[environment]\ncube = { px = \"a.png\" }\n",
     "scene.toml:3:8: error: a cube environment needs the key 'nx'"},
    {"UnknownSetting", "[settings]\nsp = 3\n",
     "scene.toml:3:1: error: unknown setting 'sp' (did you mean 'spp'?)"},
    {"SettingOutOfRange", "[settings]\nmax_depth = 17\n",
     "scene.toml:3:1: error: setting 'max_depth': expected an integer from 0 to 16, got '17'"},
    {"Syntax", "[[camera]\n", "scene.toml:2:"},
};
INSTANTIATE_TEST_SUITE_P(Scenes, WrongToml, ::testing::ValuesIn(kWrongScenes),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(TomlScene, DocumentationHasEveryKey) {
    std::ifstream stream(RAYSCOPE_SOURCE_DIR "/docs/scene-format.md");
    const std::string page(std::istreambuf_iterator<char>(stream), {});
    // The error about an unknown key lists the known keys of the table.
    int lists = 0;
    for (const char* body :
         {"x = 1", "[[camera]]\nx = 1", "[[camera]]\nlook_from = [0, 0, 1]\nlens = { x = 1 }",
          "[[mesh]]\nx = 1", "[[mesh]]\ntransform = { x = 1 }", "[[sphere]]\nx = 1", "[material.a]\nx = 1",
          "[[light]]\ntype = \"point\"\nx = 1", "[[light]]\ntype = \"segment\"\nx = 1",
          "[[light]]\ntype = \"parallelogram\"\nx = 1", "[environment]\nx = 1"}) {
        std::string list = failure(std::string(body) + "\n");
        ASSERT_THAT(list, HasSubstr("; expected ")) << body;
        list.erase(0, list.find("; expected ") + 11);
        std::replace(list.begin(), list.end(), ',', ' ');
        std::istringstream words(list);
        for (std::string key; words >> key;) {
            if (key == "or") continue;
            const bool isNamed = page.find(key + "`") != std::string::npos ||
                                 page.find(key + "]") != std::string::npos ||
                                 page.find(key + ".NAME") != std::string::npos;
            EXPECT_TRUE(isNamed) << key;
        }
        ++lists;
    }
    EXPECT_EQ(lists, 11);
}

TEST_F(TomlScene, NeedsASupportedVersion) {
    EXPECT_EQ(errorOf(write("none.toml", "title = \"a\"\n")),
              "none.toml:1:1: error: a scene needs the key 'version'; write version = 1");
    EXPECT_EQ(errorOf(write("two.toml", "version = 2\n")),
              "two.toml:1:11: error: version: expected an integer from 1 to 1, got 2");
}

TEST_F(TomlScene, UnreadableFilesAreErrorsWithTheReason) {
    EXPECT_EQ(errorOf((folder_ / "gone.toml").string()),
              "gone.toml: error: cannot be read: No such file or directory");
    std::filesystem::create_directories(folder_ / "folder.toml");
    EXPECT_EQ(errorOf((folder_ / "folder.toml").string()), "folder.toml: error: is a folder, not a file");
    EXPECT_THAT(
        errorOf(write("picture.png", "")),
        HasSubstr("picture.png: error: unknown scene format; expected a .toml file, a mesh file (.obj"));
}

TEST_F(TomlScene, EmptyImageIsAnErrorWithItsName) {
    write("empty.png", "");
    EXPECT_THAT(failure("[material.a]\nkd_texture = \"empty.png\"\n"), HasSubstr("empty.png"));
}

}  // namespace
}  // namespace rayscope::test
