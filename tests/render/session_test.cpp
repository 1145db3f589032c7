#include <gtest/gtest.h>

#include <rayscope/render_session.h>
#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

#include "math/vectors.h"
#include "render/film.h"
#include "support/image_hash.h"
#include "support/test_scenes.h"

namespace rayscope {
namespace {

/// A floor, a mirror, a transparent pane and a sphere under an area light: all kinds of rays.
std::shared_ptr<const SceneDescription> richScene() {
    SceneDescription scene;
    scene.path = "test";
    scene.cameras.push_back(test::frontCamera(3.0f));
    scene.materials = {test::material(Rgb(0.7f, 0.5f, 0.3f)), test::material(Rgb(0.1f), Rgb(0.8f), 20.0f),
                       test::material(Rgb(0.2f, 0.3f, 0.9f), Rgb(0.0f), 1.0f, 0.4f)};
    scene.meshes = {test::quad({-2, -0.8f, -2}, {4, 0, 0}, {0, 0, 4}, 0),
                    test::quad({-1, -0.8f, -1.5f}, {2, 0, 0}, {0, 2, 0}, 1),
                    test::quad({-0.9f, -0.7f, 0.6f}, {0.8f, 0, 0}, {0, 1, 0}, 2)};
    scene.spheres = {{"ball", {{0.4f, -0.4f, 0.0f}, 0.4f}, 1, glm::vec3(0.0f)}};
    scene.lights = {test::pointLight({1, 2, 2}),
                    {ParallelogramLight{{-1, 1.5f, 0}, {{{0.5f, 0, 0}, {0, 0, 0.5f}}}, {}}, Falloff::None}};
    for (Rgb& color : std::get<ParallelogramLight>(scene.lights[1].shape).colors) color = Rgb(0.5f);
    return std::make_shared<const SceneDescription>(std::move(scene));
}

RenderRequest requestFor(std::shared_ptr<const SceneDescription> scene, int size = 70, int spp = 8) {
    RenderRequest request;
    request.camera = scene->cameras.front();
    request.scene = std::move(scene);
    request.width = size;
    request.height = size - 10;
    request.settings.spp = spp;
    request.settings.parallelogramSamples = 2;
    return request;
}

std::uint64_t renderedHash(const RenderRequest& request, int threads) {
    RenderSession session(threads);
    session.submit(request);
    EXPECT_EQ(session.wait(), RenderState::Done);
    return test::hashOf(*session.picture()->film());
}

TEST(Session, GivesTheSameBitsForAnyThreadCountAndPassPlan) {
    RenderRequest request = requestFor(richScene());
    request.progressive = false;
    const std::uint64_t expected = renderedHash(request, 1);
    EXPECT_NE(expected, 0u);
    for (const int threads : {1, 2, 4, 7}) {
        for (const bool progressive : {false, true}) {
            request.progressive = progressive;
            EXPECT_EQ(renderedHash(request, threads), expected)
                << threads << " threads, progressive " << progressive;
        }
    }
    request.seed = 1;
    EXPECT_NE(renderedHash(request, 2), expected);
}

TEST(Session, GivesTheSameBitsAfterFiveHundredCancellations) {
    const RenderRequest request = requestFor(richScene(), 64, 16);
    const std::uint64_t expected = renderedHash(request, 2);
    RenderSession session(3);
    std::mt19937 random(1);
    int cancellations = 0;
    while (cancellations < 500) {
        session.submit(request);
        session.wait(1e-6 * static_cast<double>(random() % 3000));
        if (session.status().state == RenderState::Done) {
            // The image was completed between two cancellations: replace the film.
            RenderRequest other = request;
            other.seed = random() | 2u;
            session.submit(other);
            session.wait(1e-4);
        }
        random() % 2 ? session.cancel() : session.finishTiles();
        ++cancellations;
        session.collect([](const TileView&) {});
    }
    session.submit(request);
    EXPECT_EQ(session.wait(), RenderState::Done);
    EXPECT_EQ(test::hashOf(*session.picture()->film()), expected);
}

TEST(Session, ContinuesTheFilmIfOnlyTheSampleCountGrows) {
    RenderRequest request = requestFor(richScene(), 50, 4);
    RenderSession session(2);
    session.submit(request);
    session.wait();
    const auto film = session.picture()->film();
    const std::uint64_t raysBefore = session.status().rays;
    request.settings.spp = 8;
    session.submit(request);
    session.wait();
    EXPECT_EQ(session.picture()->film(), film);
    EXPECT_GT(session.status().rays, raysBefore);
    EXPECT_EQ(session.status().samples, 8);
    EXPECT_EQ(test::hashOf(*session.picture()->film()), renderedHash(request, 1));
}

TEST(Session, KeepsTheFilmIfOnlyTheDisplayChanges) {
    RenderRequest request = requestFor(richScene(), 50, 4);
    RenderSession session(2);
    session.submit(request);
    session.wait();
    const auto film = session.picture()->film();
    request.settings.exposure = 1.0f;
    request.settings.bloom = true;
    session.submit(request);
    EXPECT_EQ(session.wait(), RenderState::Done);
    EXPECT_EQ(session.picture()->film(), film);
    request.settings.shading = false;
    session.submit(request);
    session.wait();
    EXPECT_NE(session.picture()->film(), film);
}

TEST(Session, SharesGeometryBetweenWorldsIfALightMoves) {
    const auto scene = richScene();
    RenderSession session(2);
    session.submit(requestFor(scene, 50, 1));
    session.wait();
    const auto before = session.picture()->world();
    SceneDescription moved = *scene;
    std::get<PointLight>(moved.lights[0].shape).position.x += 1.0f;
    session.submit(requestFor(std::make_shared<const SceneDescription>(moved), 50, 1));
    session.wait();
    EXPECT_NE(session.picture()->world(), before);
    EXPECT_EQ(session.picture()->world()->motionGroups[0].accel, before->motionGroups[0].accel);
}

TEST(Session, ANewRequestReplacesTheCurrentOne) {
    const auto scene = richScene();
    RenderSession session(2);
    for (int i = 0; i < 60; ++i) {
        RenderRequest request = requestFor(scene, 90, 64);
        request.seed = static_cast<std::uint64_t>(i);
        session.submit(request);
    }
    RenderRequest last = requestFor(scene, 40, 2);
    last.seed = 99;
    session.submit(last);
    EXPECT_EQ(session.wait(), RenderState::Done);
    EXPECT_EQ(session.picture()->film()->width(), 40);
    EXPECT_EQ(test::hashOf(*session.picture()->film()), renderedHash(last, 1));
    EXPECT_EQ(session.status().epoch, 61u);
}

/// More samples than can be rendered during a test.
constexpr int kEndless = 1 << 20;

void waitForSamples(const RenderSession& session, int samples) {
    while (session.status().samples < samples) std::this_thread::yield();
}

TEST(Session, PausesAndResumes) {
    RenderRequest request = requestFor(richScene(), 60, kEndless);
    RenderSession session(2);
    session.submit(request);
    waitForSamples(session, 1);
    session.pause();
    EXPECT_EQ(session.wait(), RenderState::Paused);
    const std::uint64_t hash = test::hashOf(*session.picture()->film());
    const int samples = session.status().samples;
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    EXPECT_EQ(test::hashOf(*session.picture()->film()), hash);

    session.resume();
    waitForSamples(session, samples + 1);
    session.cancel();
    EXPECT_EQ(session.wait(), RenderState::Idle);
    // Some tiles are one pass ahead: with the samples of that pass everywhere, the image is that of one
    // render.
    request.settings.spp = 2 * session.status().samples;
    session.submit(request);
    EXPECT_EQ(session.wait(), RenderState::Done);
    EXPECT_EQ(test::hashOf(*session.picture()->film()), renderedHash(request, 1));
}

TEST(Session, PausesARequestThatHasNotStarted) {
    const RenderRequest request = requestFor(richScene(), 60, 2);
    RenderRequest endless = request;
    endless.settings.spp = kEndless;
    endless.seed = 1;
    RenderSession session(2);
    for (int i = 0; i < 20; ++i) {
        session.submit(endless);
        session.submit(i % 2 ? request : endless);
        session.pause();
        session.wait();
        // The short request may be done before it is paused, but nothing else can end the wait.
        const RenderState state = session.status().state;
        ASSERT_TRUE(state == RenderState::Paused || (i % 2 == 1 && state == RenderState::Done));
    }
    session.submit(request);
    session.pause();
    session.resume();
    EXPECT_EQ(session.wait(), RenderState::Done);
    EXPECT_EQ(test::hashOf(*session.picture()->film()), renderedHash(request, 1));
}

/// A callback of collect() that copies tiles into the image.
auto pasteInto(RgbImage& image) {
    return [&image](const TileView& tile) {
        for (int y = 0; y < tile.height; ++y)
            for (int x = 0; x < tile.width; ++x)
                image.at(tile.x0 + x, tile.y0 + y) = tile.mean[static_cast<std::size_t>(y * tile.width + x)];
    };
}

TEST(Session, DeliversEachTileOnceAfterEachChange) {
    const RenderRequest request = requestFor(richScene(), 70, 2);
    RenderSession session(2);
    session.submit(request);
    session.wait();
    RgbImage seen(request.width, request.height, Rgb(-1.0f));
    session.collect(pasteInto(seen));
    EXPECT_EQ(seen.pixels, session.picture()->film()->mean().pixels);
    EXPECT_EQ(session.collect([](const TileView&) {}), 0);
}

TEST(Session, PollingDeliversTheFinalImage) {
    const RenderRequest request = requestFor(richScene(), 70, 64);
    RenderSession session(2);
    session.submit(request);
    RgbImage seen(request.width, request.height, Rgb(-1.0f));
    int delivered = 0;
    while (session.status().state != RenderState::Done) {
        delivered += session.collect(pasteInto(seen));
        ASSERT_NE(session.status().state, RenderState::Failed);
    }
    session.collect(pasteInto(seen));
    EXPECT_GT(delivered, 0);
    EXPECT_EQ(seen.pixels, session.picture()->film()->mean().pixels);
}

TEST(Session, RendersOnlyTheRegion) {
    RenderRequest request = requestFor(richScene(), 70, 2);
    RenderSession whole(2), part(2);
    whole.submit(request);
    request.region = PixelBounds{10, 45, 5, 40};
    part.submit(request);
    whole.wait();
    part.wait();
    const RgbImage a = whole.picture()->film()->mean(), b = part.picture()->film()->mean();
    for (int y = 0; y < request.height; ++y)
        for (int x = 0; x < request.width; ++x) {
            const bool inside = x >= 10 && x < 45 && y >= 5 && y < 40;
            EXPECT_EQ(b.at(x, y), inside ? a.at(x, y) : Rgb(0.0f));
        }
}

TEST(Session, CountsNonFiniteSamplesAndKeepsThemInTheFilm) {
    SceneDescription scene = *richScene();
    std::get<PointLight>(scene.lights[0].shape).color = Rgb(3e38f);
    scene.lights[0].falloff = Falloff::InverseSquare;
    std::get<PointLight>(scene.lights[0].shape).position = {0.0f, -0.8f + 1e-30f, 0.2f};
    scene.materials[0].kd = Rgb(std::numeric_limits<float>::infinity());
    RenderSession session(2);
    session.submit(requestFor(std::make_shared<const SceneDescription>(scene), 50, 1));
    EXPECT_EQ(session.wait(), RenderState::Done);
    EXPECT_GT(session.status().nonFiniteSamples, 0u);
    const RgbImage mean = session.picture()->film()->mean();
    EXPECT_TRUE(std::ranges::any_of(mean.pixels, [](const Rgb& pixel) { return !math::isFinite(pixel); }));
}

TEST(Session, IsDestroyedWithoutCompletingTheImage) {
    std::shared_ptr<const render::Film> film;
    {
        RenderSession session(2);
        session.submit(requestFor(richScene(), 60, kEndless));
        waitForSamples(session, 1);
        EXPECT_EQ(session.status().state, RenderState::Rendering);
        film = session.picture()->film();
    }
    EXPECT_GE(film->completeSamples(), 1);
    EXPECT_LT(film->completeSamples(), kEndless);
}

TEST(Session, AnEmptySceneIsBlack) {
    SceneDescription scene;
    scene.cameras.push_back(test::frontCamera(3.0f));
    RenderSession session(2);
    session.submit(requestFor(std::make_shared<const SceneDescription>(scene), 50, 1));
    EXPECT_EQ(session.wait(), RenderState::Done);
    for (const Rgb& pixel : session.picture()->film()->mean().pixels) EXPECT_EQ(pixel, Rgb(0.0f));
}

}  // namespace
}  // namespace rayscope
