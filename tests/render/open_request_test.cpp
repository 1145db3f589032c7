#include <gtest/gtest.h>

#include <rayscope/open_request.h>

namespace rayscope {
namespace {

std::shared_ptr<const SceneDescription> twoCameras() {
    auto scene = std::make_shared<SceneDescription>();
    scene->cameras.resize(2);
    scene->cameras[1].name = "front";
    scene->cameras[1].fov = 30.0f;
    scene->settings = {{"max_depth", "2", {}}, {"spp", "4", {}}, {"parallelogram_samples", "7", {}}};
    return scene;
}

std::string errorOf(const RequestOverrides& overrides) {
    try {
        requestFor(twoCameras(), overrides);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(OpenRequest, LaterSourcesOfSettingsOverrideEarlierOnes) {
    RequestOverrides overrides;
    EXPECT_EQ(requestFor(twoCameras()).settings.spp, 4);
    overrides.preset = "preview";
    const Settings preview = requestFor(twoCameras(), overrides).settings;
    EXPECT_NE(preview.spp, 4);
    EXPECT_NE(preview.parallelogramSamples, 7);
    overrides.settings = {{"spp", "9", {}}, {"max_depth", "3", {}}};
    EXPECT_EQ(requestFor(twoCameras(), overrides).settings.spp, 9);
    overrides.spp = 11;
    const Settings settings = requestFor(twoCameras(), overrides).settings;
    EXPECT_EQ(settings.spp, 11);
    EXPECT_EQ(settings.maxDepth, 3);
    EXPECT_EQ(settings.parallelogramSamples, preview.parallelogramSamples);
}

TEST(OpenRequest, OverridesPartsOfTheNamedCamera) {
    RequestOverrides overrides;
    overrides.camera.name = "front";
    overrides.camera.lookAt = glm::vec3(1.0f);
    overrides.width = 30;
    overrides.seed = 5;
    const RenderRequest request = requestFor(twoCameras(), overrides);
    EXPECT_EQ(request.camera.fov, 30.0f);
    EXPECT_EQ(request.camera.lookAt, glm::vec3(1.0f));
    EXPECT_EQ(request.camera.lookFrom, twoCameras()->cameras[1].lookFrom);
    EXPECT_EQ(request.width, 30);
    EXPECT_EQ(request.seed, 5u);
}

TEST(OpenRequest, FramesASceneWithoutCameras) {
    const auto scene = std::make_shared<const SceneDescription>();
    EXPECT_EQ(requestFor(scene).camera, framingCamera(boundsOf(*scene)));
}

TEST(OpenRequest, NamesTheNearestCameraAndTheOthers) {
    RequestOverrides overrides;
    overrides.camera.name = "frint";
    EXPECT_NE(errorOf(overrides).find("did you mean 'front'"), std::string::npos);
    EXPECT_NE(errorOf(overrides).find("it has main or front"), std::string::npos);
}

TEST(OpenRequest, RefusesACameraAtThePointThatItLooksAt) {
    RequestOverrides overrides;
    overrides.camera.lookFrom = overrides.camera.lookAt = glm::vec3(2.0f);
    EXPECT_NE(errorOf(overrides).find("same point"), std::string::npos);
}

TEST(OpenRequest, RefusesAnUndefinedRotation) {
    RequestOverrides overrides;
    overrides.camera.up = glm::vec3(0.0f);
    EXPECT_EQ(errorOf(overrides), "error: camera: up must not be zero");
    for (const float length : {-1.0f, 1e-30f, 1.0f, 1e30f}) {
        overrides.camera.up = glm::vec3(0.0f, 0.0f, length);  // the camera is on the z axis
        EXPECT_NE(errorOf(overrides).find("camera: up is parallel to the viewing direction"),
                  std::string::npos);
    }
    overrides.camera.up = glm::vec3(0.0f, 1e-30f, 1e-30f);
    EXPECT_EQ(errorOf(overrides), "");
}

TEST(OpenRequest, ReportsWhereAWrongSettingIs) {
    RequestOverrides overrides;
    overrides.settings = {{"max_dept", "2", {"x.toml", 3, 1}}};
    EXPECT_NE(errorOf(overrides).find("x.toml:3:1"), std::string::npos);
    EXPECT_THROW(checkOverrides(overrides), InputError);
    overrides.settings.clear();
    overrides.preset = "previeu";
    EXPECT_THROW(checkOverrides(overrides), InputError);
}

}  // namespace
}  // namespace rayscope
