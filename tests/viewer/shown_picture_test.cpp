// The picture in the view, its label and what is kept and saved of it.
#include "viewer/jobs/shown_picture.h"

#include <gtest/gtest.h>

#include <thread>

#include "render/film.h"
#include "traced.h"
#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {
namespace {

EditState stateOf(const std::string& scene, int spp) {
    Diagnostics notes;
    EditState state = initialState(loadScene("builtin:" + scene, notes));
    state.settings.spp = spp;
    return state;
}

/// A workspace with the ray-traced view, without a window.
struct TracedWorkspace {
    Workspace workspace;
    explicit TracedWorkspace(const EditState& state, glm::ivec2 size = {96, 64}) : workspace(state, {}, 2) {
        workspace.viewSize = size;
        workspace.view.traced = true;
    }
    void frame(bool moving = false) { workspace.updateTracing(moving); }
    bool complete() const {
        const ShownPicture& shown = workspace.shown;
        return shown.isFull(workspace.edit, workspace.imageSize()) &&
               shown.leastSamples() == workspace.edit.settings.spp && !workspace.render.busy() &&
               shown.source()->film() == workspace.render.session().picture()->film();
    }
    void settle() {
        for (frame(); !complete(); frame()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        frame();
    }
};

RgbImage rendered(const EditState& state, glm::ivec2 size) { return traced(state, size).still().mean(); }

TEST(ShownPicture, HasTheSamplesOfItsLabelAfterTheNumberOfSamplesWasLowered) {
    TracedWorkspace view(stateOf("spheres", 16));
    view.settle();
    const RgbImage sixteen = view.workspace.shown.image();
    view.workspace.edit.settings.spp = 1;
    view.frame();
    EXPECT_EQ(noticeOf(view.workspace.shown, view.workspace.edit, {96, 64}, 1),
              "previous picture with 16 samples per pixel");
    view.settle();
    EXPECT_EQ(view.workspace.shown.leastSamples(), 1);
    EXPECT_EQ(view.workspace.shown.image().pixels, rendered(view.workspace.edit, {96, 64}).pixels);
    EXPECT_NE(view.workspace.shown.image().pixels, sixteen.pixels);
    EXPECT_EQ(view.workspace.shown.request()->settings.spp, 1);
}

TEST(ShownPicture, AnAIsLabelledWithWhatItWasTracedWith) {
    TracedWorkspace view(stateOf("spheres", 4));
    view.settle();
    view.workspace.edit.settings.spp = 1;
    // The picture of 4 samples is still in the view: it is no picture of this state.
    view.workspace.keepPicture();
    const auto* a = view.workspace.comparison.a();
    if (a != nullptr) {
        EXPECT_EQ(a->picture.leastSamples(), 4);
        EXPECT_EQ(a->picture.request().settings.spp, 4);
    }
    view.settle();
    view.workspace.keepPicture();
    ASSERT_NE(view.workspace.comparison.a(), nullptr);
    EXPECT_EQ(view.workspace.comparison.a()->picture.leastSamples(), 1);
}

/// Tab, Home, typed numbers and the like: a change without a drag.
TEST(ShownPicture, NeverMixesTwoViews) {
    TracedWorkspace view(stateOf("cornell-area", 2), {160, 96});
    view.settle();
    for (int change = 0; change < 12; ++change) {
        const RgbImage before = view.workspace.shown.image();
        const RenderRequest beforeRequest = *view.workspace.shown.request();
        view.workspace.edit.camera.fov += 2.0f;
        const RgbImage after = rendered(
            [&] {
                EditState one = view.workspace.edit;
                one.settings.spp = 1;
                return one;
            }(),
            {160, 96});
        bool replaced = false;
        for (; !view.complete(); std::this_thread::sleep_for(std::chrono::microseconds(300))) {
            view.frame(change % 3 == 2 && !replaced);
            const ShownPicture& shown = view.workspace.shown;
            if (shown.source()->request().camera == beforeRequest.camera) {
                ASSERT_FALSE(replaced) << "the earlier view does not come back";
                ASSERT_EQ(shown.image().pixels, before.pixels) << "the earlier view stays whole";
                ASSERT_EQ(noticeOf(shown, view.workspace.edit, {160, 96}, 1), "previous view");
                continue;
            }
            replaced = true;
            ASSERT_TRUE(previewDivisor(shown.source()->request(), requestOf(view.workspace.edit, 160, 96)));
        }
        EXPECT_TRUE(replaced);
    }
}

TEST(ShownPicture, KeepsItsPixelsWhileTheRasterisedViewIsShown) {
    TracedWorkspace view(stateOf("spheres", 8));
    view.settle();
    const RgbImage complete = view.workspace.shown.image();
    const auto film = view.workspace.shown.source()->film();
    view.workspace.view.traced = false;
    for (int i = 0; i < 5; ++i) view.frame();
    EXPECT_NE(view.workspace.render.currentWorld(), nullptr);
    view.workspace.view.traced = true;
    view.settle();
    EXPECT_EQ(view.workspace.shown.source()->film(), film) << "nothing is traced again";
    EXPECT_EQ(view.workspace.shown.image().pixels, complete.pixels);
}

TEST(ShownPicture, RestsAtOneSampleBesideTheRasterisedViewAndGoesOnAfterwards) {
    TracedWorkspace view(stateOf("spheres", 4096), {64, 48});
    while (view.workspace.shown.leastSamples() < 1) view.frame();
    view.workspace.view.traced = false;
    do view.frame();
    while (view.workspace.render.busy());
    const int samples = view.workspace.shown.leastSamples();
    EXPECT_LT(samples, 4096);
    EXPECT_NE(view.workspace.render.currentWorld(), nullptr) << "for debug rays";
    view.workspace.view.traced = true;
    while (view.workspace.shown.leastSamples() <= samples) view.frame();
    EXPECT_GE(view.workspace.shown.source()->film()->mostSamples(), samples);
}

TEST(ShownPicture, NamesTheRadianceOfPixelsOfThisViewOnly) {
    TracedWorkspace view(stateOf("spheres", 2));
    view.settle();
    const EditState before = view.workspace.edit;
    ASSERT_TRUE(view.workspace.shown.radiance(before, {96, 64}, {48, 32}));
    EXPECT_EQ(*view.workspace.shown.radiance(before, {96, 64}, {48, 32}),
              view.workspace.shown.image().at(48, 32));
    EditState other = before;
    other.camera.lookFrom.x += 0.1f;
    EXPECT_FALSE(view.workspace.shown.radiance(other, {96, 64}, {48, 32}));
    EXPECT_FALSE(view.workspace.shown.radiance(before, {192, 128}, {48, 32}));
}

TEST(ShownPicture, IsLabelledWithTheBloomThatItHas) {
    TracedWorkspace view(stateOf("spheres", 1));
    view.settle();
    Settings& settings = view.workspace.edit.settings;
    settings.bloom = true;
    settings.bloomSize = 3;
    view.frame();
    for (; !view.workspace.shown.bloomShown(); view.frame())
        EXPECT_FALSE(view.workspace.shown.request()->settings.bloom);
    EXPECT_EQ(view.workspace.shown.request()->settings, settings);
    EXPECT_EQ(view.workspace.shown.displayed().pixels,
              withBloom(view.workspace.shown.image(), settings).pixels);
    view.workspace.edit.camera.fov += 1.0f;
    while (view.workspace.shown.source()->request().camera != view.workspace.edit.camera) view.frame();
    if (!view.workspace.shown.bloomShown()) {
        EXPECT_FALSE(view.workspace.shown.request()->settings.bloom);
    }
}

}  // namespace
}  // namespace rayscope::viewer
