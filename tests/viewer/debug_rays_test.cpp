#include "viewer/jobs/debug_rays.h"

#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "traced.h"

namespace rayscope::viewer {
namespace {

EditState cornell(int spp) {
    Diagnostics notes;
    EditState state = initialState(loadScene("builtin:cornell", notes));
    state.settings.spp = spp;
    return state;
}

/// A picture of one sample per pixel, as beside the rasterised view.
TracedPicture pictureOf(EditState state) {
    state.settings.spp = 1;
    return traced(state, {48, 48});
}

void record(DebugRays& rays, const EditState& state) {
    rays.recordPixel(pictureOf(state), state.settings.spp, {24, 30, 0}, DebugRays::Compare::WithNothing);
}

void waitFor(DebugRays& rays) {
    rays.update();
    while (rays.busy()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        rays.update();
    }
}

TEST(DebugRays, recordsOneSampleAtOnceAndReplaysInTheBackground) {
    const EditState state = cornell(1);
    DebugRays rays;
    rays.recordPixel(traced(state, {48, 48}), 1, {24, 30, 0}, DebugRays::Compare::WithFilm);
    ASSERT_TRUE(rays.recording());
    EXPECT_TRUE(rays.replaying());
    EXPECT_EQ(rays.recording()->tree().nodes[0].ray.origin, state.camera.lookFrom);
    EXPECT_FALSE(rays.recording()->replayResult);
    waitFor(rays);
    ASSERT_TRUE(rays.recording()->replayResult);
    EXPECT_TRUE(rays.recording()->replayResult->good());

    rays.step(1);
    ASSERT_EQ(rays.traversals().size(), 1u);
    EXPECT_EQ(rays.traversals()[0].hit.primitive, rays.recording()->tree().nodes[0].primitiveHit.primitive);
    rays.step(100000);
    EXPECT_EQ(rays.traversal.step, static_cast<int>(rays.traversals()[0].steps.size()));
}

TEST(DebugRays, areOutdatedAfterChangesThatAffectThem) {
    const EditState state = cornell(1);
    DebugRays rays;
    record(rays, state);
    EXPECT_TRUE(rays.isOf(state, {48, 48}));
    EXPECT_FALSE(rays.isOf(state, {96, 48}));
    EditState other = state;
    other.settings.exposure = 1.0f;
    EXPECT_FALSE(rays.isOutdated(other));
    other.camera.lookFrom.x += 1.0f;
    EXPECT_FALSE(rays.isOutdated(other)) << "the camera may be moved to look at the rays";
    EXPECT_FALSE(rays.isOf(other, {48, 48}));
    other.settings.maxDepth = 1;
    EXPECT_TRUE(rays.isOutdated(other));
    rays.clear();
    EXPECT_FALSE(rays.isOutdated(other));
}

/// Follows the state until nothing is left to do.
void follow(DebugRays& rays, const EditState& state) {
    rays.follow(state, pictureOf(state));
    waitFor(rays);
}

bool equalTrees(const RayTree& a, const RayTree& b) {
    return a.radiance == b.radiance && a.nodes.size() == b.nodes.size() &&
           a.shadowRays.size() == b.shadowRays.size() && a.addends == b.addends;
}

/// Each edit changes the rays of a pixel; afterwards they are those that recording anew gives, from the
/// position of the camera of the first recording.
TEST(DebugRays, followEverythingThatChangesThemButTheCameraPosition) {
    const EditState state = cornell(4);
    const auto movedLight = [](EditState& s) {
        std::vector<Light> lights = s.scene->lights;
        std::get<PointLight>(lights.front().shape).position.x += 0.3f;
        s.scene = withLights(*s.scene, std::move(lights));
    };
    const std::function<void(EditState&)> edits[] = {[](EditState& s) { s.settings.maxDepth = 1; },
                                                     [](EditState& s) { s.settings.hardShadows = false; },
                                                     [](EditState& s) { s.settings.spp = 9; },
                                                     [](EditState& s) { s.settings.bvhBins = 5; },
                                                     [](EditState& s) { s.settings.bvhLeafSize = 1; },
                                                     [](EditState& s) { s.settings.glossySamples = 7; },
                                                     [](EditState& s) {
                                                         s.camera.lens = Lens{1.0f, 0.5f, 2.0f};
                                                     },
                                                     [](EditState& s) { s.camera.fov = 30.0f; },
                                                     movedLight};
    for (const auto& edit : edits) {
        DebugRays rays;
        record(rays, state);
        EditState edited = state;
        edit(edited);
        ASSERT_TRUE(rays.isOutdated(edited)) << &edit - edits;
        edited.camera.lookFrom.y += 0.5f;
        follow(rays, edited);
        EXPECT_FALSE(rays.isOutdated(edited)) << &edit - edits;
        edited.camera.lookFrom = state.camera.lookFrom;
        DebugRays anew;
        record(anew, edited);
        waitFor(anew);
        EXPECT_TRUE(equalTrees(rays.recording()->tree(), anew.recording()->tree())) << &edit - edits;
        EXPECT_EQ(rays.recording()->samples(), edited.settings.spp);
        EXPECT_EQ(rays.recording()->pixel.values, anew.recording()->pixel.values) << &edit - edits;
    }
}

TEST(DebugRays, doNotFollowWhileFrozenOrOfAnotherPicture) {
    const EditState state = cornell(4);
    DebugRays rays;
    record(rays, state);
    waitFor(rays);
    EditState edited = state;
    edited.settings.maxDepth = 0;
    const int version = rays.version();
    rays.frozen = true;
    follow(rays, edited);
    EXPECT_EQ(rays.version(), version);
    EXPECT_TRUE(rays.isOutdated(edited));
    rays.frozen = false;
    rays.follow(edited, pictureOf(state));
    EXPECT_FALSE(rays.busy()) << "the world of the edited state is not compiled yet";
    follow(rays, edited);
    EXPECT_FALSE(rays.isOutdated(edited));
}

TEST(DebugRays, keepTheSelectedRayWhereTheRaysAreTheSame) {
    EditState state = cornell(1);
    DebugRays rays;
    record(rays, state);
    rays.select({0, 1});
    std::vector<Light> lights = state.scene->lights;
    std::get<PointLight>(lights.front().shape).color = Rgb(0.1f);
    state.scene = withLights(*state.scene, std::move(lights));
    follow(rays, state);
    EXPECT_EQ(rays.selection(), (RaySelection{0, 1}));
    state.scene = withLights(*state.scene, {});
    follow(rays, state);
    EXPECT_TRUE(rays.selection().empty()) << "there is no ray with this number";
}

TEST(DebugRays, areClearedByAnotherScene) {
    DebugRays rays;
    record(rays, cornell(1));
    Diagnostics notes;
    const EditState other = initialState(loadScene("builtin:spheres", notes));
    rays.follow(other, std::nullopt);
    EXPECT_EQ(rays.recording(), nullptr);
}

TEST(DebugRays, recordSamplesWithinTheBudget) {
    const EditState state = cornell(64);
    DebugRays rays;
    record(rays, state);
    EXPECT_EQ(rays.recording()->trees.size(), 1u);
    rays.showAllSamples(true);
    waitFor(rays);
    EXPECT_EQ(rays.recording()->trees.size(), 64u);
    rays.selectSample(40);
    EXPECT_EQ(rays.recording()->tree().name.index, 40);
    EXPECT_EQ(rays.recording()->trees.size(), 64u) << "nothing is recorded again";
    rays.budget = 4096;
    rays.showAllSamples(true);
    waitFor(rays);
    EXPECT_LT(rays.recording()->trees.size(), 20u);
    EXPECT_EQ(rays.recording()->tree().name.index, 40) << "the selected sample is always recorded";
    EXPECT_EQ(rays.recording()->samples(), 64);
}

TEST(DebugRays, diagnoseInTheBackground) {
    const EditState state = cornell(64);
    DebugRays rays;
    record(rays, state);
    EXPECT_EQ(rays.diagnose(), nullptr);
    waitFor(rays);
    ASSERT_NE(rays.diagnose(), nullptr);
    const std::vector<probe::Diagnosis> expected =
        probe::diagnosePixel(*rays.recording()->world, 0, 24, 30, 64);
    ASSERT_EQ(rays.diagnose()->size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ((*rays.diagnose())[i].sentence, expected[i].sentence);
}

TEST(DebugRays, cancelledJobsLeaveTheRecordingUsable) {
    const EditState state = cornell(4096);
    DebugRays rays;
    record(rays, state);
    rays.diagnose();
    rays.cancelReplay();
    rays.cancelDiagnosis();
    waitFor(rays);
    // Work that ended before the request is kept.
    const bool finished = rays.diagnose() != nullptr;
    EXPECT_FALSE(rays.diagnosing()) << "a cancelled diagnosis starts on request only";
    EXPECT_EQ(finished, rays.recording()->diagnosis.has_value());
    EXPECT_FALSE(rays.recording()->pixel.values.empty());
    EXPECT_EQ(rays.recording()->tree().nodes[0].ray.origin, state.camera.lookFrom);
    rays.restartDiagnosis();
    rays.diagnose();
    waitFor(rays);
    EXPECT_NE(rays.diagnose(), nullptr);
}

TEST(DebugRays, pinsAPixelOnceItsSamplesAreReplayed) {
    const EditState state = cornell(256);
    DebugRays rays;
    record(rays, state);
    const auto world = rays.recording()->world;
    rays.pin();
    EXPECT_TRUE(rays.pins.empty());
    waitFor(rays);
    ASSERT_EQ(rays.pins.size(), 1u);
    EXPECT_EQ(rays.pins[0].mean, probe::statisticsOf(probe::replayPixel(*world, 0, 24, 30, 256).values).mean);
}

}  // namespace
}  // namespace rayscope::viewer
