// A film and the request that it was traced for stay together.
#include <gtest/gtest.h>
#include <rayscope/render_image.h>

#include <chrono>
#include <random>

#include "support/test_scenes.h"

namespace rayscope {
namespace {

/// A square under a light, seen askew, so that pixels and samples differ.
RenderRequest litSquare(int size, int spp) {
    RenderRequest request = test::squareRequest(size);
    SceneDescription scene = *request.scene;
    scene.lights = {test::pointLight({1, 2, 2})};
    request.scene = std::make_shared<const SceneDescription>(std::move(scene));
    request.camera.lookFrom.x = 1.0f;
    request.settings.spp = spp;
    return request;
}

TEST(TracedPicture, FewerSamplesStartAnotherFilm) {
    RenderRequest request = litSquare(50, 8);
    RenderSession session(2);
    session.submit(request);
    session.wait();
    const TracedPicture before = *session.picture();
    request.settings.spp = 2;
    session.submit(request);
    EXPECT_EQ(session.wait(), RenderState::Done);
    EXPECT_NE(session.picture()->film(), before.film());
    EXPECT_EQ(session.picture()->still().mostSamples(), 2);
    EXPECT_EQ(session.picture()->still().mean().pixels, renderImage(request).mean.pixels);
    EXPECT_EQ(before.still().leastSamples(), 8) << "the earlier picture keeps its film and its request";
    EXPECT_EQ(before.request().settings.spp, 8);
}

TEST(TracedPicture, MoreSamplesContinueTheFilmOfEarlierPictures) {
    RenderRequest request = litSquare(50, 1);
    RenderSession session(2);
    session.submit(request);
    session.wait();
    const TracedPicture before = *session.picture();
    request.settings.spp = 2;
    session.submit(request);
    EXPECT_EQ(session.wait(), RenderState::Done);
    const StillPicture still = before.still();
    EXPECT_EQ(still.mostSamples(), 2);
    EXPECT_EQ(still.request().settings.spp, 2)
        << "a picture is never labelled with fewer samples than it has";
    EXPECT_EQ(still.mean().pixels, renderImage(request).mean.pixels);
}

/// While requests follow one another, each tile belongs to the request that it names.
TEST(TracedPicture, IsThatOfItsRequestWhileRequestsReplaceOneAnother) {
    std::vector<RenderRequest> requests;
    std::vector<RgbImage> expected;
    for (int i = 0; i < 4; ++i) {
        requests.push_back(litSquare(50 + i, 1));
        requests.back().camera.fov += static_cast<float>(i);
        requests.back().seed = static_cast<std::uint64_t>(i);
        expected.push_back(renderImage(requests.back()).mean);
    }
    RenderSession session(3);
    const auto start = std::chrono::steady_clock::now();
    session.submit(requests[0]);
    session.wait();
    // So that some requests are replaced before they have tiles, and some are completed, on any machine.
    const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::mt19937 random(7);
    for (int tiles = 0; tiles < 1000;) {
        session.submit(requests[random() % 4]);
        session.wait(1e-3 * static_cast<double>(random() % 1500) * whole);
        tiles += session.collect([&](const TileView& tile) {
            const std::uint64_t i = tile.picture.request().seed;
            ASSERT_EQ(tile.picture.request().camera, requests[i].camera);
            for (int y = 0; y < tile.height; ++y)
                for (int x = 0; x < tile.width; ++x)
                    ASSERT_EQ(tile.mean[static_cast<std::size_t>(y * tile.width + x)],
                              expected[i].at(tile.x0 + x, tile.y0 + y));
        });
    }
}

TEST(TracedPicture, MetadataNameTheCommandThatRendersItAgain) {
    RenderRequest request = litSquare(20, 4);
    request.scene = [&] {
        SceneDescription scene = *request.scene;
        scene.path = "folder/my scene.toml";
        return std::make_shared<const SceneDescription>(std::move(scene));
    }();
    request.camera.lens = Lens{2.0f, 0.125f, 3.0f};
    const auto metadataFor = [](const RenderRequest& wanted) {
        RenderSession session(1);
        session.submit(wanted);
        session.wait();
        return metadataOf(session.picture()->still());
    };
    const ImageMetadata metadata = metadataFor(request);
    EXPECT_EQ(metadata.at("samples"), "4");
    EXPECT_NE(metadata.at("camera").find("--lens 2,0.125,3"), std::string::npos);
    const std::string& command = metadata.at("command");
    EXPECT_TRUE(command.starts_with("rayscope render 'my scene.toml' --size 20x20")) << command;
    EXPECT_NE(command.find("--lens 2,0.125,3"), std::string::npos) << command;
    EXPECT_NE(command.find("--set spp=4"), std::string::npos) << command;
    SceneDescription edited = *request.scene;
    edited.edited = true;
    request.scene = std::make_shared<const SceneDescription>(std::move(edited));
    EXPECT_FALSE(metadataFor(request).contains("command")) << "no command renders an edited scene";
    EXPECT_EQ(metadataFor(request).at("scene.edited"), "true");
}

}  // namespace
}  // namespace rayscope
