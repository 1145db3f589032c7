#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/render_image.h>
#include <rayscope/render_session.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include "render/cast_rays.h"
#include "support/test_scenes.h"

namespace rayscope {
namespace {

using testing::HasSubstr;

RenderRequest validRequest() {
    RenderRequest request = test::squareRequest(8);
    request.settings.spp = 1;
    return request;
}

std::string messageOfSubmit(const std::function<void(RenderRequest&)>& edit) {
    RenderRequest request = validRequest();
    edit(request);
    RenderSession session(1);
    try {
        session.submit(request);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(InvalidRequest, WithoutScene) {
    EXPECT_THAT(messageOfSubmit([](RenderRequest& r) { r.scene = nullptr; }), HasSubstr("scene is null"));
    EXPECT_THROW(renderImage(RenderRequest{}), std::invalid_argument);
    EXPECT_THROW(compileScene(RenderRequest{}), std::invalid_argument);
}

TEST(InvalidRequest, Size) {
    for (const auto& [width, height] : std::initializer_list<std::pair<int, int>>{
             {0, 0}, {8, 0}, {-5, 7}, {-5, -7}, {1 << 30, 1 << 30}, {100000, 100000}})
        EXPECT_THAT(messageOfSubmit([&](RenderRequest& r) {
                        r.width = width;
                        r.height = height;
                    }),
                    HasSubstr("expected 1 … 268435456 pixels"))
            << width << " x " << height;
}

TEST(InvalidRequest, Region) {
    constexpr int kMin = std::numeric_limits<int>::min(), kMax = std::numeric_limits<int>::max();
    for (const PixelBounds& region :
         {PixelBounds{100, 200, 100, 200}, PixelBounds{-1, 8, 0, 8}, PixelBounds{0, 9, 0, 8},
          PixelBounds{5, 2, 5, 2}, PixelBounds{5, 5, 5, 5}, PixelBounds{kMin, kMax, kMin, kMax}})
        EXPECT_THAT(messageOfSubmit([&](RenderRequest& r) { r.region = region; }),
                    HasSubstr("empty or outside the image of 8 x 8 pixels"));
}

TEST(InvalidRequest, Settings) {
    EXPECT_THAT(messageOfSubmit([](RenderRequest& r) { r.settings.spp = 0; }),
                HasSubstr("settings: spp is 0; expected 1 … 1048576"));
    EXPECT_THAT(messageOfSubmit([](RenderRequest& r) {
                    r.settings.glossySigma = std::numeric_limits<float>::quiet_NaN();
                }),
                HasSubstr("settings: glossy_sigma is nan"));
    EXPECT_THAT(
        messageOfSubmit([](RenderRequest& r) { r.settings.bvhBuilder = static_cast<BvhBuilder>(99); }),
        HasSubstr("settings: bvh_builder is enumerator 99; expected 0 … 3"));
}

TEST(InvalidRequest, References) {
    EXPECT_THAT(messageOfSubmit([](RenderRequest& r) {
                    SceneDescription scene = *r.scene;
                    scene.meshes[0].data = nullptr;
                    r.scene = std::make_shared<const SceneDescription>(scene);
                }),
                HasSubstr("data is null"));
}

/// Found by the background thread, because it takes time.
TEST(InvalidRequest, VertexIndicesEndInFailed) {
    RenderRequest request = validRequest();
    SceneDescription scene = *request.scene;
    auto data = std::make_shared<MeshData>(*scene.meshes[0].data);
    data->triangles[0].x = 77;
    scene.meshes[0].data = data;
    request.scene = std::make_shared<const SceneDescription>(scene);
    RenderSession session(1);
    session.submit(request);
    EXPECT_EQ(session.wait(60.0), RenderState::Failed);
    EXPECT_THAT(session.status().message, HasSubstr("vertex indices 77"));
}

/// The session keeps rendering valid requests after an invalid one.
TEST(InvalidRequest, LeavesTheSessionUsable) {
    RenderSession session(1);
    EXPECT_THROW(session.submit({}), std::invalid_argument);
    EXPECT_EQ(session.status().state, RenderState::Idle);
    session.submit(validRequest());
    EXPECT_EQ(session.wait(60.0), RenderState::Done);
    EXPECT_THROW(session.collect({}), std::invalid_argument);
}

TEST(InvalidRequest, Threads) {
    EXPECT_THROW(RenderSession(-1), std::invalid_argument);
    EXPECT_THROW(RenderSession(kMaxThreads + 1), std::invalid_argument);
}

TEST(InvalidRequest, RaysWithoutPlaceForTheirResults) {
    const auto world = test::compileScene(*validRequest().scene, {}, 8, 8);
    const std::vector<Ray> rays(2);
    std::vector<Hit> hits(1);
    std::vector<std::uint8_t> occluded(3);
    EXPECT_THROW(render::castClosest(*world, rays, hits), std::invalid_argument);
    EXPECT_THROW(render::castAny(*world, rays, occluded), std::invalid_argument);
}

}  // namespace
}  // namespace rayscope
