#include "viewer/jobs/scene_loader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace rayscope::viewer {
namespace {

using ::testing::HasSubstr;
using Clock = std::chrono::steady_clock;

/// Seconds in which a load must end after a request to stop, also on a busy machine.
constexpr double kPrompt = 5.0;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

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
    const auto start = Clock::now();
    loader.cancel();
    EXPECT_FALSE(loader.loading());
    EXPECT_FALSE(wait(loader));
    // The whole load takes several times as long.
    EXPECT_LT(secondsSince(start), kPrompt);
}

TEST(SceneLoader, ALaterRequestReplacesTheFirst) {
    SceneLoader loader;
    startLong(loader);
    const auto start = Clock::now();
    loader.start("builtin:cube", false);
    EXPECT_EQ(loader.path(), "builtin:cube");
    const auto loaded = wait(loader);
    ASSERT_TRUE(loaded && loaded->scene);
    EXPECT_EQ(loaded->path, "builtin:cube");
    EXPECT_LT(secondsSince(start), kPrompt);
}

TEST(SceneLoader, EndsPromptlyWhenTheProgramQuits) {
    auto start = Clock::now();
    {
        SceneLoader loader;
        startLong(loader);
        start = Clock::now();
    }
    EXPECT_LT(secondsSince(start), kPrompt);
}

}  // namespace
}  // namespace rayscope::viewer
