#include "viewer/jobs/save_queue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rayscope/image.h>
#include <rayscope/save_scene.h>

#include <filesystem>
#include <thread>

#include "support/run_program.h"
#include "support/temporary_folder.h"
#include "viewer/model/edit_state.h"

namespace rayscope::viewer {
namespace {

using ::testing::HasSubstr;

SaveQueue::Outcome wait(SaveQueue& queue) {
    for (;;) {
        if (auto outcome = queue.poll()) return *outcome;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

TEST(SaveQueue, WritesInOrderAndReportsEachEntry) {
    SaveQueue queue;
    std::vector<int> written;
    for (int i = 0; i < 3; ++i)
        queue.add({std::to_string(i), "x"}, [&written, i] {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            written.push_back(i);
        });
    EXPECT_TRUE(queue.busy());
    EXPECT_EQ(queue.current(), "0 and x");
    for (int i = 0; i < 3; ++i) {
        const SaveQueue::Outcome outcome = wait(queue);
        EXPECT_EQ(outcome.names, std::to_string(i) + " and x");
        EXPECT_EQ(outcome.error, "");
    }
    EXPECT_EQ(written, (std::vector{0, 1, 2}));
    EXPECT_FALSE(queue.busy());
    EXPECT_EQ(queue.current(), "");
}

TEST(SaveQueue, ReportsErrorsAndGoesOn) {
    const test::TemporaryFolder folder;
    SaveQueue queue;
    const std::string wrong = folder / "nowhere" / "a.png", right = folder / "b.png";
    for (const std::string& path : {wrong, right})
        queue.add({path}, [path] { writeImage(path, RgbImage(4, 4)); });
    EXPECT_THAT(wait(queue).error, HasSubstr("a.png"));
    EXPECT_EQ(wait(queue).error, "");
    EXPECT_TRUE(std::filesystem::exists(right));
}

TEST(SaveQueue, NamesAreFreeOfWhatIsStillToBeWritten) {
    SaveQueue queue;
    const std::string first = queue.nextFreeName(".none");
    queue.add({first}, [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); });
    const std::string second = queue.nextFreeName(".none");
    EXPECT_NE(first, second);
    queue.add({"a", second}, [] {});
    EXPECT_NE(queue.nextFreeName(".none"), second);
    wait(queue);
    wait(queue);
    EXPECT_EQ(queue.nextFreeName(".none"), first) << "nothing was written";
}

TEST(SaveQueue, EverythingIsWrittenBeforeItEnds) {
    int written = 0;
    {
        SaveQueue queue;
        for (int i = 0; i < 4; ++i)
            queue.add({"x"}, [&] {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                ++written;
            });
    }
    EXPECT_EQ(written, 4);
}

TEST(SavedScene, OpensInTheEditedState) {
    const test::TemporaryFolder folder;
    Diagnostics notes;
    EditState state = initialState(loadScene("builtin:cornell", notes));
    std::vector<Light> lights = state.scene->lights;
    std::get<PointLight>(lights.at(0).shape).position.y = 0.1f + 0.2f;
    state.scene = withLights(*state.scene, lights);
    state.settings.maxDepth += 1;
    state.camera.fov = 41.3f;
    state.camera.lens = Lens{};
    saveScene(sceneOf(state), folder.file("saved.toml"));
    const EditState opened = initialState(loadScene(folder.file("saved.toml"), notes));
    EXPECT_EQ(opened.scene->lights, state.scene->lights);
    EXPECT_EQ(opened.settings, state.settings);
    EXPECT_EQ(opened.camera, state.camera);
}

}  // namespace
}  // namespace rayscope::viewer
