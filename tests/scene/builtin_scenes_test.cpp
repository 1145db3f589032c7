#include <algorithm>
#include <cstdlib>

#include "scene_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;

const char* const kDocumentedNames[] = {"triangle",
                                        "cube",
                                        "cube-textured",
                                        "cornell",
                                        "cornell-area",
                                        "cornell-glossy",
                                        "cornell-transparent",
                                        "monkey",
                                        "teapot",
                                        "dragon",
                                        "spheres",
                                        "spheres-dof",
                                        "quad-textured",
                                        "cubes-transparent",
                                        "environment",
                                        "custom",
                                        "million",
                                        "ten-million"};

TEST(BuiltinScenes, HaveDocumentedNamesAndTitles) {
    const auto scenes = builtinScenes();
    EXPECT_EQ(scenes.size(), std::size(kDocumentedNames));
    for (const char* name : kDocumentedNames) {
        const auto found =
            std::find_if(scenes.begin(), scenes.end(), [&](const auto& s) { return s.name == name; });
        ASSERT_NE(found, scenes.end()) << name;
        EXPECT_TRUE(found->title.ends_with(".")) << name;
    }
}

class BuiltinScene : public ::testing::TestWithParam<const char*> {};

TEST_P(BuiltinScene, LoadsWithoutWarnings) {
    const std::string name = GetParam();
    Diagnostics notes;
    SceneDescription scene;
    try {
        scene = loadScene("builtin:" + name, notes);
    } catch (const InputError& error) {
        // Its mesh is fetched separately.
        ASSERT_EQ(name, "dragon") << error.what();
        EXPECT_THAT(error.what(), HasSubstr("run 'rayscope fetch dragon' once"));
        return;
    }
    EXPECT_EQ(scene.path, "builtin:" + name);
    EXPECT_TRUE(notes.empty()) << toString(notes.front());
    EXPECT_FALSE(scene.title.empty());
    EXPECT_FALSE(scene.lights.empty());
    for (const Diagnostic& found : lint(scene)) EXPECT_EQ(found.severity, Severity::Note) << toString(found);
    const auto file = loadScene(std::string(RAYSCOPE_SOURCE_DIR "/scenes/") + name + ".toml", notes);
    EXPECT_EQ(requirementsOf(file).triangles, requirementsOf(scene).triangles);
}
INSTANTIATE_TEST_SUITE_P(All, BuiltinScene, ::testing::ValuesIn(kDocumentedNames), [](const auto& tested) {
    std::string name = tested.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(BuiltinScenes, HaveTheDocumentedTriangleCounts) {
    Diagnostics notes;
    const auto triangles = [&](const char* name) { return requirementsOf(loadScene(name, notes)).triangles; };
    EXPECT_EQ(triangles("builtin:triangle"), 1u);
    EXPECT_EQ(triangles("builtin:cornell"), 32u);
    EXPECT_EQ(triangles("builtin:cornell-transparent"), 44u);
    EXPECT_EQ(triangles("builtin:cubes-transparent"), 36u);
    EXPECT_EQ(triangles("builtin:quad-textured"), 2u);
    EXPECT_EQ(triangles("builtin:teapot"), 15704u);
    EXPECT_EQ(triangles("builtin:million"), 1000000u);
    EXPECT_EQ(triangles("builtin:ten-million"), 10000000u);
}

TEST(BuiltinScenes, MissingDragonMeshHasAdvice) {
    // A copy of the scene in an empty folder.
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("dragonless-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::filesystem::copy_file(RAYSCOPE_SOURCE_DIR "/scenes/dragon.toml", folder / "dragon.toml",
                               std::filesystem::copy_options::overwrite_existing);
    Diagnostics notes;
    try {
        loadScene((folder / "dragon.toml").string(), notes);
        ADD_FAILURE() << "loaded a missing mesh";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("dragon.toml:11:8: error: mesh file not found: "));
        EXPECT_THAT(error.what(), HasSubstr("; run 'rayscope fetch dragon' once"));
    }
    std::filesystem::remove_all(folder);
}

TEST(BuiltinScenes, CornellBoxHasItsDimensions) {
    Diagnostics notes;
    const SceneBounds bounds = boundsOf(loadScene("builtin:cornell", notes));
    // Dimensions of the original mesh, whose coordinates are rounded to 0.5 %.
    const glm::vec3 lower(-0.52983f, -0.40747f, -0.54739f), upper(0.53610f, 0.64262f, 0.52381f);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(bounds.lower[axis], lower[axis], 0.003f);
        EXPECT_NEAR(bounds.upper[axis], upper[axis], 0.003f);
    }
}

TEST(BuiltinScenes, UnknownNameSuggestsTheNearest) {
    Diagnostics notes;
    try {
        loadScene("builtin:cornel", notes);
        ADD_FAILURE() << "loaded an unknown scene";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("unknown built-in scene 'cornel' (did you mean 'cornell'?)"));
    }
}

}  // namespace
}  // namespace rayscope::test
