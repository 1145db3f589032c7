#include "viewer/jobs/render_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace rayscope::viewer {
namespace {

using oneapi::tbb::global_control;

std::size_t allowedThreads() { return global_control::active_value(global_control::max_allowed_parallelism); }

RenderControl::ViewRequest cube(bool moving) {
    Diagnostics notes;
    RenderControl::ViewRequest request;
    request.state = initialState(loadScene("builtin:cube", notes));
    request.width = request.height = 16;
    request.moving = moving;
    return request;
}

TEST(RenderControl, tracesOnAllCoresButOneWhileSomethingMoves) {
    RenderControl control(0);
    const std::size_t all = std::max(1u, std::thread::hardware_concurrency());
    EXPECT_EQ(static_cast<std::size_t>(control.threads()), all);
    if (all < 2) GTEST_SKIP() << "one core";
    control.update(cube(true));
    EXPECT_EQ(allowedThreads(), all - 1);
    control.update(cube(true));
    EXPECT_EQ(allowedThreads(), all - 1);
    control.update(cube(false));
    EXPECT_GE(allowedThreads(), all);
}

TEST(RenderControl, keepsAGivenNumberOfThreads) {
    RenderControl control(3);
    EXPECT_EQ(control.threads(), 3);
    control.update(cube(true));
    EXPECT_GE(allowedThreads(), 3u);
}

}  // namespace
}  // namespace rayscope::viewer
