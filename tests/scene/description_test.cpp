// Transforms, bounds, framing camera, requirements and lint of descriptions.
#include "scene_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], 1e-12);
}

glm::dvec3 apply(const Transform& transform, const glm::dvec3& point) {
    return glm::dvec3(matrixOf(transform) * glm::dvec4(point, 1.0));
}

TEST(Transform, ScalesThenRotatesAboutXYZThenTranslates) {
    Transform transform{2.0f, {90.0f, 0.0f, 90.0f}, {10.0f, 0.0f, 0.0f}, {}};
    // (0, 1, 0) · 2 = (0, 2, 0); about x: (0, 0, 2); about z unchanged; translated.
    expectNear(apply(transform, {0, 1, 0}), {10, 0, 2});
    // (1, 0, 0) · 2 = (2, 0, 0); about x unchanged; about z: (0, 2, 0); translated.
    expectNear(apply(transform, {1, 0, 0}), {10, 2, 0});
    transform.matrix = glm::mat4(1.0f);
    expectNear(apply(transform, {1, 2, 3}), {1, 2, 3});
}

SceneDescription sphereScene() {
    SceneDescription scene;
    scene.materials.push_back({.name = "a"});
    scene.spheres.push_back({"ball", {{1, 2, 3}, 0.5f}, 0, {}});
    scene.lights.push_back({PointLight{}});
    scene.cameras.push_back({});
    return scene;
}

MeshInstance meshInstance(MeshData data) {
    MeshInstance mesh{.name = "mesh", .data = std::make_shared<MeshData>(std::move(data))};
    mesh.materials = {0};
    return mesh;
}

TEST(Bounds, CoverSpheresAndTransformedMeshes) {
    SceneDescription scene = sphereScene();
    EXPECT_EQ(boundsOf(scene).lower, glm::vec3(0.5f, 1.5f, 2.5f));
    scene.meshes.push_back(
        meshInstance({.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}}));
    scene.meshes[0].transform.translate = {-5, 0, 0};
    EXPECT_EQ(boundsOf(scene).lower, glm::vec3(-5, 0, 0));
    EXPECT_EQ(boundsOf(scene).upper, glm::vec3(1.5f, 2.5f, 3.5f));
    EXPECT_EQ(boundsOf({}).lower, glm::vec3(-0.5f));
}

TEST(FramingCamera, ShowsTheWholeBox) {
    for (const float size : {1e-6f, 1.0f, 1e6f}) {
        const SceneBounds bounds{glm::vec3(-1, -2, -3) * size, glm::vec3(2, 2, 2) * size};
        const CameraDescription camera = framingCamera(bounds);
        const glm::dvec3 from(camera.lookFrom), forward = glm::normalize(glm::dvec3(camera.lookAt) - from);
        for (int corner = 0; corner < 8; ++corner) {
            glm::dvec3 point;
            for (int axis = 0; axis < 3; ++axis)
                point[axis] =
                    static_cast<double>(corner >> axis & 1 ? bounds.upper[axis] : bounds.lower[axis]);
            const double angle = std::acos(glm::dot(glm::normalize(point - from), forward));
            EXPECT_LT(glm::degrees(angle), 0.5 * static_cast<double>(camera.fov));
        }
        EXPECT_GT(camera.lookFrom.z, bounds.upper.z) << "from the front";
        EXPECT_GT(camera.lookFrom.y, camera.lookAt.y) << "from above";
    }
}

TEST(Requirements, HaveReasons) {
    SceneDescription scene = sphereScene();
    SceneRequirements needs = requirementsOf(scene);
    EXPECT_EQ(needs.spheres, 1u);
    EXPECT_EQ(needs.triangles, 0u);
    EXPECT_TRUE(needs.pointLights);
    EXPECT_FALSE(needs.segmentLights || needs.parallelogramLights || needs.reflections ||
                 needs.transparency || needs.textures || needs.environment || needs.lens || needs.motion ||
                 needs.smoothNormals);

    scene.materials.push_back({.name = "glass", .ks = Rgb(0.5f), .opacity = 0.5f});
    EXPECT_FALSE(requirementsOf(scene).reflections) << "unused material";
    scene.spheres[0].material = 1;
    scene.spheres[0].motion = {1, 0, 0};
    scene.cameras[0].lens = Lens{};
    scene.lights.push_back({SegmentLight{}});
    auto environment = std::make_shared<Environment>();
    environment->equirect = std::make_shared<Texture>(Texture{"generated", RgbImage(2, 1)});
    scene.environment = environment;
    needs = requirementsOf(scene);
    EXPECT_TRUE(needs.reflections && needs.transparency && needs.motion && needs.lens &&
                needs.segmentLights && needs.environment);
    const auto find = [&](std::string_view name) {
        for (const Requirement& requirement : needs.list)
            if (requirement.name == name) return requirement;
        return Requirement{};
    };
    EXPECT_TRUE(find("reflections").needed);
    EXPECT_EQ(find("reflections").reason, "ks of material 'glass'");
    EXPECT_EQ(find("segment lights").reason, "1 segment light");
    EXPECT_FALSE(find("triangles").needed);
    EXPECT_EQ(find("triangles").reason, "no mesh");
}

std::string lintText(const SceneDescription& scene) {
    std::string text;
    for (const Diagnostic& found : lint(scene)) text += toString(found) + "\n";
    return text;
}

TEST(Lint, FindsNothingInAValidScene) { EXPECT_THAT(lintText(sphereScene()), IsEmpty()); }

TEST(Lint, FindsInvalidMaterials) {
    SceneDescription scene = sphereScene();
    scene.materials[0].kd = Rgb(0.8f);
    scene.materials[0].ks = Rgb(0.3f);
    scene.materials[0].shininess = 0.0f;
    scene.materials.push_back({.name = "spare"});
    EXPECT_THAT(lintText(scene), HasSubstr("not energy-conserving: kd + ks = 1.1"));
    EXPECT_THAT(lintText(scene), HasSubstr("shininess 0"));
    EXPECT_THAT(lintText(scene), HasSubstr("material 'spare' is not used"));
    scene.materials[0].ks = Rgb(0.2f);
    EXPECT_THAT(lintText(scene), ::testing::Not(HasSubstr("kd + ks")));
}

TEST(Lint, FindsInvalidMeshes) {
    SceneDescription scene = sphereScene();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    scene.meshes.push_back(
        meshInstance({.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {nan, 0, 0}},
                      .normals = {{0, 0, -1}, {0, 0, -1}, {0, 0, -1}, {0, 0, 0}, {0, 0, 1}},
                      .triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}}));
    EXPECT_THAT(lintText(scene), HasSubstr("1 triangles have NaN or infinite vertices"));
    EXPECT_THAT(lintText(scene), HasSubstr("1 degenerate triangles (zero area), the first has index 1"));
    EXPECT_THAT(lintText(scene), HasSubstr("1 vertex normals are zero"));
    EXPECT_THAT(lintText(scene), HasSubstr("1 of 3 triangles are oriented against their vertex normals"));
    scene.materials[0].kdTexture =
        std::make_shared<Texture>(Texture{"a", RgbImage(1, 1), TextureWrap::Repeat});
    EXPECT_THAT(lintText(scene), HasSubstr("has no texture coordinates"));
}

TEST(Lint, FindsInvalidLightsAndCameras) {
    SceneDescription scene = sphereScene();
    scene.lights = {{PointLight{{}, Rgb(0.0f)}}, {SegmentLight{{glm::vec3(1), glm::vec3(1)}}}};
    scene.cameras[0].lookFrom = {1, 2, 3};
    scene.cameras[0].lens = Lens{2.0f, 1.0f, 0.5f};
    EXPECT_THAT(lintText(scene), HasSubstr("light 1 is black"));
    EXPECT_THAT(lintText(scene), HasSubstr("light 2: the segment has zero length"));
    EXPECT_THAT(lintText(scene), HasSubstr("camera 'main' is inside 'ball'"));
    EXPECT_THAT(lintText(scene), HasSubstr("a lens cannot focus at or within its focal_length"));
    EXPECT_THAT(lintText({}), HasSubstr("no light"));
    EXPECT_THAT(lintText({}), HasSubstr("no geometry"));
}

TEST(Lint, LeavesOutWhatIsKnown) {
    const SceneDescription empty;
    const Diagnostics found = lint(empty);
    EXPECT_EQ(found.size(), 2u);
    EXPECT_TRUE(lint(empty, found).empty());
    EXPECT_EQ(lint(empty, {found[0]}).size(), 1u);
}

TEST(Lint, WorksAtEveryScale) {
    for (const float size : {1e-30f, 1.0f, 1e30f}) {
        SceneDescription scene = sphereScene();
        auto mesh = std::make_shared<MeshData>();
        mesh->positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
        mesh->normals.assign(3, {0, 0, -1});
        mesh->triangles = {{0, 1, 2}};
        scene.meshes = {{"m", mesh, {}, {0}}};
        scene.spheres[0].sphere = {{size, 0, 0}, size};
        scene.cameras[0].lookFrom = {1.5f * size, 0, 0};
        EXPECT_THAT(lintText(scene), HasSubstr("1 of 1 triangles are oriented against their vertex normals"));
        EXPECT_THAT(lintText(scene), HasSubstr("is inside"));
        scene.cameras[0].lookFrom = {2.5f * size, 0, 0};
        EXPECT_THAT(lintText(scene), ::testing::Not(HasSubstr("is inside")));
    }
}

}  // namespace
}  // namespace rayscope::test
