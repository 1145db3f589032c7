// The tracer gives the same bits with and without a recorder, in every shipped scene.
#include <gtest/gtest.h>

#include <rayscope/probe.h>
#include <rayscope/render_session.h>
#include <cstring>
#include <stdexcept>

#include "render/film.h"
#include "support/test_scenes.h"
#include "trace/compile.h"
#include "trace/radiance.h"

namespace rayscope {
namespace {

bool sameBits(const RgbSum& a, const RgbSum& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

struct Opened {
    RenderRequest request;
    bool present = false;
};

Opened open(const std::string& name, int size) {
    Opened opened;
    Diagnostics notes;
    try {
        opened.request.scene = std::make_shared<const SceneDescription>(loadScene("builtin:" + name, notes));
    } catch (const InputError&) {
        return opened;  // a mesh that has to be fetched first
    }
    opened.present = true;
    opened.request.camera = opened.request.scene->cameras.front();
    opened.request.width = opened.request.height = size;
    for (const SettingAssignment& a : opened.request.scene->settings)
        assign(opened.request.settings, a.key, a.value);
    return opened;
}

class Replay : public testing::TestWithParam<std::string> {};

TEST_P(Replay, RecordedSamplesEqualUnrecordedOnes) {
    Opened opened = open(GetParam(), 24);
    if (!opened.present) GTEST_SKIP() << "mesh not fetched";
    const RenderRequest& r = opened.request;
    const auto world = trace::compile({r.scene, r.settings, r.camera, r.width, r.height});
    trace::NullObserver silent;
    for (int y = 0; y < r.height; ++y)
        for (int x = 0; x < r.width; ++x)
            for (int index = 0; index < 2; ++index) {
                const SampleId name{x, y, index};
                const RayTree tree = probeSample(*world, 3, name);
                ASSERT_TRUE(sameBits(tree.radiance, trace::radiance(*world, 3, name, silent).radiance))
                    << x << " " << y;
                RgbSum sum(0.0);
                for (const RgbSum& addend : tree.addends) sum += addend;
                ASSERT_TRUE(sameBits(sum, tree.radiance)) << x << " " << y;
            }
}

TEST_P(Replay, ReplayedPixelsEqualTheFilm) {
    Opened opened = open(GetParam(), 20);
    if (!opened.present) GTEST_SKIP() << "mesh not fetched";
    opened.request.settings.spp = 4;
    for (const int threads : {1, 2, 7}) {
        RenderSession session(threads);
        session.submit(opened.request);
        ASSERT_EQ(session.wait(), RenderState::Done);
        for (int y = 0; y < opened.request.height; ++y)
            for (int x = 0; x < opened.request.width; ++x) {
                const ReplayResult replayed = verifyReplay(
                    *session.picture()->world(), *session.picture()->film(), opened.request.seed, x, y);
                ASSERT_TRUE(replayed.matchesFilm) << x << " " << y;
                ASSERT_TRUE(replayed.sumMatches) << x << " " << y;
                ASSERT_EQ(replayed.samples, 4);
            }
    }
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtinScenes())
        if (scene.name != "million" && scene.name != "ten-million") names.push_back(scene.name);
    return names;
}
std::string testName(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(Scenes, Replay, testing::ValuesIn(sceneNames()), testName);

TEST(VerifyReplay, PixelsOutsideTheFilmThrow) {
    const auto world = test::compileScene({}, {}, 4, 4);
    const render::Film film(4, 4, {1, 3, 1, 3});
    for (const auto& [x, y] : {std::pair{-1, 1}, {0, 1}, {3, 1}, {99999, 1}, {1, 3}})
        EXPECT_THROW(verifyReplay(*world, film, 0, x, y), std::invalid_argument) << x << ", " << y;
}

}  // namespace
}  // namespace rayscope
