#include "measure/trade/timed_render.h"
#include "measure/statistics/deadline.h"

#include <gtest/gtest.h>
#include <rayscope/render_session.h>

#include "support/test_scenes.h"

namespace rayscope {
namespace {

trace::CompileRequest requestFor(const std::string& name, int size, int spp) {
    Diagnostics notes;
    auto scene = std::make_shared<const SceneDescription>(loadScene(name, notes));
    Settings settings;
    settings.spp = spp;
    return {scene, settings, scene->cameras.front(), size, size};
}

TEST(Deadline, RequestsAStopByTimeOrWithTheOuterToken) {
    const measure::Deadline soon(0.01, {});
    while (!soon.token().stop_requested()) std::this_thread::yield();
    std::stop_source stop;
    const measure::Deadline never(1e9, stop.get_token());
    EXPECT_FALSE(never.token().stop_requested());
    stop.request_stop();
    EXPECT_TRUE(never.token().stop_requested());
}

TEST(TimedRender, EqualsARenderSession) {
    render::ThreadArena workers(2);
    const trace::CompileRequest request = requestFor("builtin:cornell-area", 20, 3);
    const std::optional<measure::TimedRender> timed =
        measure::renderTimed(workers, request, nullptr, 5, 1e9, {});
    ASSERT_TRUE(timed);
    RenderSession session(2);
    RenderRequest render;
    render.scene = request.scene;
    render.settings = request.settings;
    render.camera = request.camera;
    render.width = render.height = 20;
    render.seed = 5;
    session.submit(render);
    ASSERT_EQ(session.wait(), RenderState::Done);
    RgbImage image(20, 20);
    session.collect([&](const TileView& tile) {
        for (int y = 0; y < tile.height; ++y)
            for (int x = 0; x < tile.width; ++x)
                image.at(tile.x0 + x, tile.y0 + y) = tile.mean[static_cast<std::size_t>(y * tile.width + x)];
    });
    EXPECT_EQ(image.pixels, timed->image.pixels);
    EXPECT_EQ(session.status().rays, timed->rays);
}

TEST(TimedRender, StopsAtItsTimeLimit) {
    render::ThreadArena workers(2);
    EXPECT_FALSE(
        measure::renderTimed(workers, requestFor("builtin:cornell-area", 100, 100000), nullptr, 0, 0.05, {}));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(measure::renderTimed(workers, requestFor("builtin:teapot", 20, 1), nullptr, 0, 1e9,
                                      stop.get_token()));
}

}  // namespace
}  // namespace rayscope
