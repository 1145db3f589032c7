#include "viewer/jobs/scene_loader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <thread>

namespace rayscope::viewer {
namespace {

using ::testing::HasSubstr;

/// Processor time of this program, in seconds; other programs do not lengthen it.
double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::optional<LoadedScene> wait(SceneLoader& loader) {
    for (;;) {
        if (auto loaded = loader.poll()) return loaded;
        if (!loader.busy()) return std::nullopt;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// Starts a load that takes seconds, and waits until it is under way.
void startLong(SceneLoader& loader) {
    loader.start("builtin:ten-million", false);
    while (loader.step().name.find("terrain") == std::string::npos)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(SceneLoader, DeliversASceneWithItsBounds) {
    SceneLoader loader;
    loader.start("builtin:cornell", false);
    const auto loaded = wait(loader);
    ASSERT_TRUE(loaded && loaded->scene);
    EXPECT_EQ(loaded->bounds, boundsOf(*loaded->scene));
    EXPECT_FALSE(loader.loading());
}

TEST(SceneLoader, DeliversErrors) {
    SceneLoader loader;
    loader.start("missing.toml", false);
    const auto loaded = wait(loader);
    ASSERT_TRUE(loaded);
    EXPECT_FALSE(loaded->scene);
    EXPECT_THAT(loaded->error, HasSubstr("missing.toml"));
}

TEST(SceneLoader, ACancelledLoadDeliversNothing) {
    SceneLoader loader;
    startLong(loader);
    EXPECT_THAT(loader.step().name, HasSubstr("mesh 1 of 1: generating a terrain"));
    const double start = processorSeconds();
    loader.cancel();
    EXPECT_FALSE(loader.loading());
    EXPECT_FALSE(wait(loader));
    EXPECT_THAT(loader.step().name, HasSubstr("generating a terrain")) << "no later step began";
    EXPECT_LT(processorSeconds() - start, 1.0);
}

TEST(SceneLoader, ALaterRequestReplacesTheFirst) {
    SceneLoader loader;
    startLong(loader);
    const double start = processorSeconds();
    loader.start("builtin:cube", false);
    EXPECT_EQ(loader.path(), "builtin:cube");
    const auto loaded = wait(loader);
    ASSERT_TRUE(loaded && loaded->scene);
    EXPECT_EQ(loaded->path, "builtin:cube");
    EXPECT_LT(processorSeconds() - start, 1.0);
}

TEST(SceneLoader, EndsPromptlyWhenTheProgramQuits) {
    double start = 0.0;
    {
        SceneLoader loader;
        startLong(loader);
        start = processorSeconds();
    }
    EXPECT_LT(processorSeconds() - start, 1.0);
}

}  // namespace
}  // namespace rayscope::viewer
