#include "viewer/jobs/debug_rays.h"

#include <gtest/gtest.h>

#include <thread>

#include "render/film.h"
#include "trace/compile.h"

namespace rayscope::viewer {
namespace {

EditState cornell(int spp) {
    Diagnostics notes;
    EditState state = initialState(loadScene("builtin:cornell", notes));
    state.settings.spp = spp;
    return state;
}

std::shared_ptr<const trace::World> compiled(const EditState& state) {
    return trace::compile({state.scene, state.settings, state.camera, 48, 48});
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
    RenderSession session(1);
    RenderRequest request;
    request.scene = state.scene;
    request.camera = state.camera;
    request.settings = state.settings;
    request.width = request.height = 48;
    session.submit(request);
    ASSERT_EQ(session.wait(60.0), RenderState::Done);

    DebugRays rays;
    rays.recordPixel(session.world(), state, {48, 48}, {24, 30, 0}, session.film());
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

TEST(DebugRays, areStaleAfterChangesThatAffectRays) {
    const EditState state = cornell(1);
    DebugRays rays;
    rays.recordPixel(compiled(state), state, {48, 48}, {24, 30, 0}, nullptr);
    EXPECT_FALSE(rays.isStaleFor(state, {48, 48}));
    EXPECT_TRUE(rays.isStaleFor(state, {96, 48}));
    EditState other = state;
    other.settings.exposure = 1.0f;
    EXPECT_FALSE(rays.isStaleFor(other, {48, 48}));
    other.settings.maxDepth = 1;
    EXPECT_TRUE(rays.isStaleFor(other, {48, 48}));
    other = state;
    other.camera.fov += 1.0f;
    EXPECT_TRUE(rays.isStaleFor(other, {48, 48}));
    rays.clear();
    EXPECT_FALSE(rays.isStaleFor(other, {48, 48}));
}

TEST(DebugRays, recordSamplesWithinTheBudget) {
    const EditState state = cornell(64);
    DebugRays rays;
    rays.recordPixel(compiled(state), state, {48, 48}, {24, 30, 0}, nullptr);
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
    EXPECT_EQ(rays.recording()->samples, 64);
}

TEST(DebugRays, diagnoseInTheBackground) {
    const EditState state = cornell(64);
    DebugRays rays;
    rays.recordPixel(compiled(state), state, {48, 48}, {24, 30, 0}, nullptr);
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
    rays.recordPixel(compiled(state), state, {48, 48}, {24, 30, 0}, nullptr);
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
    const auto world = compiled(state);
    DebugRays rays;
    rays.recordPixel(world, state, {48, 48}, {24, 30, 0}, nullptr);
    rays.pin();
    EXPECT_TRUE(rays.pins.empty());
    waitFor(rays);
    ASSERT_EQ(rays.pins.size(), 1u);
    EXPECT_EQ(rays.pins[0].mean, probe::statisticsOf(probe::replayPixel(*world, 0, 24, 30, 256).values).mean);
}

}  // namespace
}  // namespace rayscope::viewer
