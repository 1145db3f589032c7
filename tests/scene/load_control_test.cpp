// Progress and cancellation of loading.
#include <algorithm>
#include <functional>
#include <stop_token>

#include "scene/generate/generate.h"
#include "scene_files.h"

namespace rayscope::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

/// Records the steps, and requests a stop at the call with the number `stopAt`.
class Recorder {
  public:
    explicit Recorder(int stopAt = -1) : stopAt_(stopAt) {}
    LoadControl control() {
        return {.progress = [this](const std::string& step, double fraction) { record(step, fraction); },
                .stop = stop_.get_token()};
    }
    std::vector<std::string> names;  ///< without repetitions
    int calls = 0;

  private:
    void record(const std::string& step, double fraction) {
        EXPECT_FALSE(stop_.stop_requested()) << step << ": no progress after a stop";
        EXPECT_GE(fraction, 0.0);
        EXPECT_LE(fraction, 1.0);
        const bool isNew = names.empty() || names.back() != step;
        if (!isNew) {
            EXPECT_GE(fraction, last_) << step;
        }
        if (isNew) names.push_back(step);
        last_ = fraction;
        if (calls++ == stopAt_) stop_.request_stop();
    }

    int stopAt_;
    double last_ = 0.0;
    std::stop_source stop_;
};

/// Runs `work` once without a stop and then with a stop at several of its progress reports.
void expectStops(const std::function<void(const LoadControl&)>& work) {
    Recorder whole;
    work(whole.control());
    ASSERT_GT(whole.calls, 1);
    for (const int stopAt : {0, whole.calls / 2, whole.calls - 2}) {
        Recorder stopped(stopAt);
        EXPECT_THROW(work(stopped.control()), Stopped) << "at " << stopAt << " of " << whole.calls;
    }
}

class LoadControlTest : public SceneFiles {
  protected:
    std::string writeScene() {
        write("texture.pfm", std::string("PF\n1 1\n-1.0\n") + std::string(12, '\0'));
        write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        std::string scene = R"(version = 1
[[camera]]
look_from = [0, 0, 3]
look_at = [0, 0, 0]
[[light]]
type = "point"
position = [0, 2, 0]
[material.wood]
kd = [1, 1, 1]
kd_texture = "texture.pfm"
[[mesh]]
generate = { shape = "torus" }
material = "wood"
[[mesh]]
file = "triangle.obj"
)";
        for (int i = 0; i < 20; ++i) scene += "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n";
        return write("scene.toml", scene);
    }
};

TEST_F(LoadControlTest, NamesTheSteps) {
    Recorder recorder;
    const SceneDescription scene = loadScene(writeScene(), notes_, recorder.control());
    lint(scene, {}, recorder.control());
    EXPECT_EQ(scene.spheres.size(), 20u);
    for (const char* step : {"reading scene.toml", "parsing scene.toml", "reading texture.pfm",
                             "decoding texture.pfm", "reading [[mesh]]", "mesh 1 of 2: generating a torus",
                             "reading [[sphere]]", "checking mesh 'mesh 1'", "computing the bounds"})
        EXPECT_THAT(recorder.names, Contains(HasSubstr(step)));
}

TEST_F(LoadControlTest, ASceneStopsAtEachStep) {
    const std::string path = writeScene();
    Recorder whole;
    loadScene(path, notes_, whole.control());
    for (int stopAt = 0; stopAt + 1 < whole.calls; ++stopAt) {
        Recorder stopped(stopAt);
        EXPECT_THROW(loadScene(path, notes_, stopped.control()), Stopped) << stopped.names.back();
    }
}

TEST_F(LoadControlTest, GeneratedMeshesStop) {
    expectStops([](const LoadControl& c) { generate(scene::UvSphereShape{1.0f, 64, 64}, c); });
    expectStops([](const LoadControl& c) { generate(scene::IcosphereShape{1.0f, 4}, c); });
    expectStops([](const LoadControl& c) { generate(scene::TorusShape{}, c); });
    expectStops([](const LoadControl& c) { generate(scene::TerrainShape{}, c); });
    expectStops([](const LoadControl& c) { generate(scene::TeapotShape{}, c); });
    expectStops([](const LoadControl& c) { generate(scene::MonkeyShape{}, c); });
}

TEST_F(LoadControlTest, LintAndBoundsStop) {
    const SceneDescription scene = loadScene("builtin:monkey", notes_);
    expectStops([&](const LoadControl& c) { lint(scene, {}, c); });
    expectStops([&](const LoadControl& c) { boundsOf(scene, c); });
}

TEST_F(LoadControlTest, AnExceptionOfTheCallbackEndsTheLoad) {
    struct Enough {};
    const LoadControl control{.progress = [](const std::string&, double) { throw Enough(); }, .stop = {}};
    EXPECT_THROW(loadScene("builtin:cornell", notes_, control), Enough);
}

// The parser reads a stream in blocks of 32 bytes; files may end anywhere in one.
TEST_F(LoadControlTest, TomlIsReadToItsLastByte) {
    const std::string head = "version = 1\ntitle = \"";
    for (std::size_t size = 40; size < 110; ++size) {
        const std::string title(size - head.size() - 1, 'x');
        EXPECT_EQ(load(write("whole.toml", head + title + "\"")).title, title) << size;
        EXPECT_EQ(load(write("bom.toml", "\xef\xbb\xbf" + head + title + "\"")).title, title) << size;
        const std::string cut = errorOf(write("cut.toml", head + title.substr(2) + "\"#\xe2\x82"));
        EXPECT_THAT(cut, HasSubstr("cut.toml:2:")) << size;
        EXPECT_THAT(cut, HasSubstr("utf-8")) << size;
    }
    EXPECT_THAT(errorOf(write("empty.toml", "")), HasSubstr("needs the key 'version'"));
}

TEST_F(LoadControlTest, SuffixesAreThoseThatLoadSceneOpens) {
    const std::vector<std::string> suffixes = sceneFileSuffixes();
    EXPECT_THAT(suffixes, Contains(".toml"));
    EXPECT_THAT(suffixes, Contains(".obj"));
    for (const std::string& suffix : suffixes)
        EXPECT_THAT(errorOf((folder_ / ("missing" + suffix)).string()),
                    Not(HasSubstr("unknown scene format")));
    EXPECT_THAT(errorOf(write("scene.xyz", "")), HasSubstr("unknown scene format"));
}

}  // namespace
}  // namespace rayscope::test
