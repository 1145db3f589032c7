#include <gtest/gtest.h>
#include <rayscope/open_request.h>

namespace rayscope {
namespace {

TEST(CameraOptions, survivesPrintingAndParsing) {
    CameraDescription camera;
    camera.lookFrom = {0.1f, -3.3333333f, 1e-20f};
    camera.lookAt = {1e7f, 2.0f, -0.7f};
    camera.fov = 33.3f;
    EXPECT_EQ(withOptions(CameraDescription{}, toOptions(camera)), camera);
    camera.lens = Lens{1.4f, 0.0501f, 3.3333333f};
    EXPECT_EQ(withOptions(CameraDescription{}, toOptions(camera)), camera);
}

TEST(CameraOptions, changesOnlyWhatItNames) {
    CameraDescription camera;
    camera.up = {1.0f, 0.0f, 0.0f};
    const CameraDescription changed = withOptions(camera, "  --fov=20 ");
    EXPECT_EQ(changed.fov, 20.0f);
    EXPECT_EQ(changed.up, camera.up);
}

TEST(CameraOptions, errorsNameTheExpectedForm) {
    const auto messageOf = [](const char* text) {
        try {
            withOptions(CameraDescription{}, text);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(messageOf("--look-form 1,2,3").find("--look-from"), std::string::npos);
    EXPECT_NE(messageOf("--look-from 1,2").find("three numbers"), std::string::npos);
    EXPECT_NE(messageOf("--look-from 1,2,3,4").find("three numbers"), std::string::npos);
    EXPECT_NE(messageOf("--look-from nan,2,3").find("three numbers"), std::string::npos);
    EXPECT_NE(messageOf("--lens 2.8,0,3").find("above 0"), std::string::npos);
    EXPECT_NE(messageOf("--fov").find("a number"), std::string::npos);
    EXPECT_NE(messageOf("--fov 180").find("between 0 and 180"), std::string::npos);
    EXPECT_NE(messageOf("--look-from 0,0,0 --look-at 0,0,0").find("the same point"), std::string::npos);
    EXPECT_NE(messageOf("--up 0,0,0").find("up must not be zero"), std::string::npos);
    EXPECT_NE(messageOf("--up 0,0,1").find("parallel to the viewing direction"), std::string::npos);
}

}  // namespace
}  // namespace rayscope
