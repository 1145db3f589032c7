// Interpolated normals against the true ones of a sphere.
#include "support/statistics.h"
#include "support/tracing.h"

namespace rayscope::test {
namespace {

/// A sphere of radius 1 around the origin, of `rings` rings of twice as many quads, with or without its
/// normals. Interpolating the corners' positions and their normals is the same there, so the interpolated
/// normal is exactly the radial direction of the point that was hit.
std::shared_ptr<MeshData> sphereMesh(int rings, bool withNormals) {
    auto mesh = std::make_shared<MeshData>();
    const int columns = 2 * rings;
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i <= columns; ++i) {
            const double theta = std::numbers::pi * j / rings,
                         phi = 2.0 * std::numbers::pi * (i % columns) / columns;
            mesh->positions.push_back(glm::vec3(glm::dvec3(std::sin(theta) * std::cos(phi), std::cos(theta),
                                                           std::sin(theta) * std::sin(phi))));
        }
    if (withNormals) mesh->normals = mesh->positions;
    const auto index = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < columns; ++i) {
            mesh->triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
            mesh->triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
        }
    return mesh;
}

SceneDescription sphereScene(bool withNormals, const Transform& transform = {}) {
    SceneDescription scene;
    scene.materials = {material(Rgb(1.0f))};
    scene.meshes = {{"sphere", sphereMesh(12, withNormals), transform, {0}, glm::vec3(0)}};
    scene.cameras = {frontCamera(3.0f, 45.0f)};
    scene.lights = {pointLight({3, 4, 5})};
    return scene;
}

constexpr int kPictureSize = 48;

struct FirstHit {
    trace::Interaction at;
    glm::dvec3 point;  ///< on the ray, computed independently of the weights of the normal
};
/// The first hits of all pixels.
std::vector<FirstHit> hitsOf(const trace::World& world) {
    RecordingObserver record;
    for (int y = 0; y < kPictureSize; ++y)
        for (int x = 0; x < kPictureSize; ++x) trace::radiance(world, 0, {x, y, 0}, record);
    std::vector<FirstHit> hits;
    for (std::size_t i = 0; i < record.hits.size(); ++i)
        hits.push_back({record.hits[i], glm::dvec3(record.hitRays[i].origin) +
                                            record.hits[i].t * glm::dvec3(record.hitRays[i].direction)});
    return hits;
}

TEST(NormalInterpolation, ReproducesTheNormalsOfASphere) {
    const std::vector<FirstHit> hits =
        hitsOf(*compileScene(sphereScene(true), {}, kPictureSize, kPictureSize));
    ASSERT_GT(hits.size(), 800u);
    double worst = 0.0, worstFlat = 0.0;
    for (const auto& [at, point] : hits) {
        EXPECT_TRUE(at.interpolated);
        updateWorst(worst, glm::distance(at.normal, glm::normalize(point)));
        updateWorst(worstFlat, glm::distance(at.geometricNormal, glm::normalize(point)));
    }
    EXPECT_LT(worst, 1e-6);
    EXPECT_GT(worstFlat, 0.05);  // control: the geometric normals deviate
    reportDeviation("normal interpolation on a sphere", worst, "radians");
}

TEST(NormalInterpolation, FollowsRotationScaleAndReflection) {
    Transform transform;
    transform.scale = 0.8f;
    transform.rotate = {30, 40, 50};
    glm::mat4 mirrored(1.0f);
    mirrored[0][0] = -1.0f;
    Transform reflection;
    reflection.matrix = mirrored;
    for (const Transform& t : {transform, reflection}) {
        double worst = 0.0;
        for (const auto& [at, point] :
             hitsOf(*compileScene(sphereScene(true, t), {}, kPictureSize, kPictureSize)))
            updateWorst(worst, glm::distance(at.normal, glm::normalize(point)));
        EXPECT_LT(worst, 1e-6);
    }
}

TEST(NormalInterpolation, OfAnEllipsoidIsNearItsGradient) {
    const glm::dvec3 axes(1.5, 0.6, 1.0);
    glm::mat4 matrix(1.0f);
    for (int i = 0; i < 3; ++i) matrix[i][i] = static_cast<float>(axes[i]);
    Transform transform;
    transform.matrix = matrix;
    SceneDescription scene = sphereScene(true, transform);
    scene.meshes[0].data = sphereMesh(48, true);
    double worst = 0.0;
    for (const auto& [at, point] : hitsOf(*compileScene(scene, {}, kPictureSize, kPictureSize)))
        updateWorst(worst, glm::distance(at.normal, glm::normalize(point / (axes * axes))));
    // Vertex normals are exact; between them the error is of the second order in the facets' size of 1/15.
    EXPECT_LT(worst, 0.01);
}

TEST(NormalInterpolation, FallsBackToGeometricNormals) {
    Settings off;
    off.normalInterpolation = false;
    const auto without = compileScene(sphereScene(false), {}, kPictureSize, kPictureSize);
    const auto switchedOff = compileScene(sphereScene(true), off, kPictureSize, kPictureSize);
    for (const auto& [at, point] : hitsOf(*without)) {
        EXPECT_FALSE(at.interpolated);
        EXPECT_EQ(at.normal, at.geometricNormal);
    }
    for (int y = 0; y < kPictureSize; ++y)
        EXPECT_EQ(pixelMean(*without, 0, kPictureSize / 2, y, 1),
                  pixelMean(*switchedOff, 0, kPictureSize / 2, y, 1));
}

TEST(NormalInterpolation, SurvivesInvalidNormals) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const glm::vec3 up(0, 0, 1);
    const std::vector<std::vector<glm::vec3>> cases = {
        {glm::vec3(0), glm::vec3(0), glm::vec3(0), glm::vec3(0)},
        {up, -up, up, -up},
        {up, {nan, 0, 0}, up, up},
        {{1e30f, 0, 1e30f}, {-1e30f, 0, 1e30f}, up, up},
        {{1e-30f, 0, 0}, up, up, up}};
    for (const std::vector<glm::vec3>& normals : cases) {
        SceneDescription scene = sphereScene(false);
        MeshInstance mesh = quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
        auto data = std::make_shared<MeshData>(*mesh.data);
        data->normals = normals;
        mesh.data = data;
        scene.meshes = {mesh};
        for (const auto& [at, point] : hitsOf(*compileScene(scene, {}, kPictureSize, kPictureSize))) {
            ASSERT_NEAR(glm::length(at.normal), 1.0, 1e-12);
            ASSERT_GE(glm::dot(at.normal, at.geometricNormal), 0.0);
        }
    }
}

}  // namespace
}  // namespace rayscope::test
