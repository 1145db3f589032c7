#include "picture_labels.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rayscope/render_image.h>

#include <chrono>
#include <map>
#include <random>
#include <thread>

#include "picture_truth.h"
#include "render/film.h"
#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {

namespace {

constexpr const char* kScenes[] = {"cornell", "cornell-area", "spheres", "spheres-dof", "cube"};

EditState opened(const std::string& name) {
    Diagnostics notes;
    EditState state = initialState(loadScene("builtin:" + name, notes));
    state.settings.spp = 2;
    return state;
}

class RandomSequence {
  public:
    explicit RandomSequence(unsigned seed) : random_(seed), workspace_(opened("cornell"), {}, 2) {
        workspace_.viewSize = {40, 24};
        workspace_.view.traced = true;
    }

    void step() {
        moving_ = below(6) == 0;
        act();
        for (int frames = below(6); frames >= 0; --frames) {
            frame();
            std::this_thread::sleep_for(std::chrono::microseconds(below(1500)));
        }
        check();
    }

    /// Everything that is wanted has been traced, recorded and saved.
    void settle() {
        using Clock = std::chrono::steady_clock;
        const Clock::time_point end = Clock::now() + std::chrono::seconds(120);
        moving_ = false;
        workspace_.view.traced = true;
        workspace_.rays.frozen = false;
        for (frame(); !isSettled(); frame()) {
            // A pause takes effect some time after it was asked for.
            if (workspace_.render.paused()) workspace_.render.togglePause();
            ASSERT_LT(Clock::now(), end) << "never complete";
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
        check();
        EXPECT_EQ(tracedNotice(workspace_), "");
        RenderRequest shown = *workspace_.shown.request();
        const RenderRequest wanted = requestOf(workspace_.edit, size().x, size().y);
        EXPECT_TRUE(differencesOf(shown, wanted).empty());
        EXPECT_FALSE(workspace_.rays.isOutdated(workspace_.edit));
        save();
        while (workspace_.saves.busy()) frame();
        checkFiles();
        // A light that was moved has no command line.
        if (workspace_.edit.scene->edited && below(2)) workspace_.edit = opened(kScenes[below(5)]);
    }

    int filesWithCommand() const { return filesWithCommand_; }

  private:
    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    glm::ivec2 size() const { return workspace_.imageSize(); }

    bool isSettled() const {
        const ShownPicture& shown = workspace_.shown;
        return shown.isFull(workspace_.edit, size()) &&
               shown.leastSamples() == workspace_.edit.settings.spp && !workspace_.busy() &&
               (!workspace_.edit.settings.bloom || shown.request()->settings == workspace_.edit.settings);
    }

    void frame() {
        workspace_.updateTracing(moving_);
        workspace_.rays.update();
        workspace_.rays.follow(workspace_.edit, workspace_.render.session().picture());
        workspace_.comparison.update(workspace_.shown.displayed(), workspace_.shown.revision(), false, 0.0f);
        if (!moving_) workspace_.record();
        workspace_.reportSaves();
    }

    void act() {
        switch (below(12)) {
            case 0:
            case 1:
            case 2:
                return editSetting();
            case 3:
            case 4:
                return moveCamera();
            case 5:
                return moveLight();
            case 6:
                return below(2) ? workspace_.undo() : workspace_.redo();
            case 7:
                return changeMode();
            case 8:
                return compare();
            case 9:
                return save();
            case 10:
                return record();
            default:
                return workspace_.render.togglePause();
        }
    }

    void editSetting() {
        Settings& settings = workspace_.edit.settings;
        const int samples[] = {1, 2, 3, 4, 8};
        switch (below(9)) {
            case 0:
                settings.maxDepth = below(4);
                break;
            case 1:
                settings.hardShadows = !settings.hardShadows;
                break;
            case 2:
                settings.exposure = static_cast<float>(below(5)) - 2.0f;
                break;
            case 3:
                settings.bloom = !settings.bloom;
                break;
            case 4:
                settings.sampler = below(3) == 0 ? SamplePattern::Jittered : SamplePattern::Sobol;
                break;
            case 5:
                settings.bvhLeafSize = 1 + below(8);
                break;
            default:
                settings.spp = samples[below(5)];
        }
    }

    void moveCamera() {
        CameraDescription& camera = workspace_.edit.camera;
        switch (below(4)) {
            case 0:
                camera.lookFrom.x += 0.125f;
                break;
            case 1:
                camera.fov = 30.0f + 0.5f * static_cast<float>(below(40));
                break;
            case 2:
                if (below(2) && camera.lens)
                    camera.lens.reset();
                else
                    camera.lens = Lens{1.0f + static_cast<float>(below(4)), 0.125f, 2.5f};
                break;
            default:
                camera = requestFor(workspace_.edit.scene).camera;
        }
    }

    void moveLight() {
        std::vector<Light> lights = workspace_.edit.scene->lights;
        if (lights.empty()) return;
        if (auto* point = std::get_if<PointLight>(&lights.front().shape)) point->position.y += 0.0625f;
        lights.front().falloff = below(2) ? Falloff::None : Falloff::InverseSquare;
        workspace_.setLights(std::move(lights));
    }

    void changeMode() {
        switch (below(4)) {
            case 0:
                workspace_.edit = opened(kScenes[below(5)]);
                break;
            case 1:
                workspace_.viewSize = {33 + below(3) * 16, 24};
                break;
            default:
                workspace_.view.traced = !workspace_.view.traced;
        }
    }

    void compare() {
        if (below(4) == 0) return workspace_.comparison.discard();
        if (below(3) == 0 && workspace_.comparison.a() != nullptr) {
            workspace_.edit.settings = workspace_.comparison.a()->picture.request().settings;
            return;
        }
        workspace_.keepPicture();
    }

    void save() {
        const std::string path = (folder_ / fmt::format("{}.png", number_++)).string();
        const bool expected = workspace_.view.traced && workspace_.shown.isFull(workspace_.edit, size());
        workspace_.saveTracedPicture(path);
        if (expected) saved_[path] = {workspace_.edit, size()};
    }

    void record() {
        workspace_.rays.frozen = below(4) == 0;
        if (const auto picture = workspace_.render.currentPicture())
            workspace_.rays.recordPixel(*picture, workspace_.edit.settings.spp,
                                        {below(size().x), below(size().y), 0}, DebugRays::Compare::WithFilm);
    }

    void check() {
        checkShown();
        checkA();
        checkRays();
    }

    void checkShown() {
        const ShownPicture& shown = workspace_.shown;
        if (shown.request() == nullptr) return;
        const RenderRequest& label = *shown.request();
        ASSERT_EQ(shown.image().width, label.width);
        ASSERT_EQ(shown.image().height, label.height);
        EXPECT_LE(shown.mostSamples(), label.settings.spp);
        if (!label.settings.bloom) {
            EXPECT_EQ(shown.displayed().pixels, shown.image().pixels);
        }
        for (int i = 0; i < 2; ++i) {
            const glm::ivec2 pixel(below(label.width), below(label.height));
            const int samples = shown.samplesOf(pixel);
            if (samples == 0) continue;
            const Rgb expected = trueMean(label, pixel.x, pixel.y, samples);
            EXPECT_TRUE(haveSameBits(shown.image().at(pixel.x, pixel.y), expected))
                << pixel.x << ", " << pixel.y;
            if (const auto radiance = shown.radiance(workspace_.edit, size(), pixel)) {
                EXPECT_TRUE(haveSameBits(*radiance, expected));
            }
        }
    }

    void checkA() {
        const Comparison::Kept* a = workspace_.comparison.a();
        if (a == nullptr) return;
        const StillPicture& picture = a->picture;
        EXPECT_LE(picture.mostSamples(), picture.request().settings.spp);
        if (picture.leastSamples() != picture.mostSamples()) return;
        const glm::ivec2 pixel(below(picture.mean().width), below(picture.mean().height));
        EXPECT_TRUE(haveSameBits(picture.mean().at(pixel.x, pixel.y),
                                 trueMean(picture.request(), pixel.x, pixel.y, picture.leastSamples())));
    }

    void checkRays() {
        const DebugRays::PixelRecording* recording = workspace_.rays.recording();
        if (recording == nullptr) return;
        const RayTree& tree = recording->tree();
        const RayTree again =
            probeSample(*compileScene(recording->request), recording->request.seed, tree.name);
        EXPECT_EQ(tree.addends, again.addends);
        EXPECT_EQ(tree.nodes.size(), again.nodes.size());
        if (recording->replayResult) {
            EXPECT_TRUE(recording->replayResult->good());
        }
    }

    void checkFiles() {
        for (const auto& [path, saved] : saved_)
            filesWithCommand_ += checkSavedFile(path, saved, folder_) ? 1 : 0;
        saved_.clear();
    }

    std::mt19937 random_;
    test::TemporaryFolder folder_;
    Workspace workspace_;
    bool moving_ = false;
    int number_ = 0, filesWithCommand_ = 0;
    std::map<std::string, SavedState> saved_;
};

}  // namespace

void checkRandomSequence(int steps, unsigned seed) {
    RandomSequence sequence(seed);
    for (int step = 1; step <= steps; ++step) {
        SCOPED_TRACE(fmt::format("seed {}, step {}", seed, step));
        sequence.step();
        if (step % 25 == 0) sequence.settle();
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(sequence.filesWithCommand(), steps / 500) << "too few saved files were compared";
}

}  // namespace rayscope::viewer
