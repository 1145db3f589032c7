// Single samples that would take hours: limits and signals end them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rayscope/image.h>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;

/// Each sample takes 512 lens samples with 1,000 lights of 100 x 100 samples each.
constexpr const char* kManyLightSamples = R"(version = 1
[[camera]]
look_from = [0, 0, 3]
lens = { f_number = 2, focal_length = 0.05, focus_distance = 3 }
[[mesh]]
generate = { shape = "quad", size = [8, 8] }
[settings]
light_sample_count = "per_length"
lens_samples = 512
)";

std::string withManyLights() {
    std::string text = kManyLightSamples;
    for (int i = 0; i < 1000; ++i)
        text +=
            "[[light]]\ntype = \"parallelogram\"\ncorner = [0, 0, 2]\nedges = [[1e3, 0, 0], [0, 1e3, 0]]\n";
    return text;
}

/// Each glossy reflection is split into 4,096 rays, in a scene whose rays test 80,000 triangles one by one.
constexpr const char* kSlowRays = R"(version = 1
[[camera]]
look_from = [0, 0, 3]
[material.mirror]
ks = [1, 1, 1]
[[mesh]]
generate = { shape = "terrain", cells = [200, 200] }
transform = { rotate = [90, 0, 0], scale = 5 }
material = "mirror"
[[light]]
type = "point"
position = [0, 0, 3]
[settings]
bvh = false
glossy = true
glossy_sigma = 5
glossy_samples = 4096
)";

class LongSample : public testing::TestWithParam<const char*> {
  protected:
    LongSample() {
        folder_.write("lights.toml", withManyLights());
        folder_.write("slow.toml", kSlowRays);
    }
    /// With so many samples that both scenes take days; a run that does not answer is killed.
    ProgramResult render(const std::string& start, const std::string& options) const {
        return run(folder_, "timeout -s KILL 300 " + start + " '" + RAYSCOPE_PROGRAM + "' render " +
                                GetParam() + " --size 16x16 --spp 1000000 -q -o a.pfm " + options);
    }
    bool hasImage() const { return readImage((folder_ / "a.pfm").string()).width == 16; }

  private:
    TemporaryFolder folder_;
};

TEST_P(LongSample, EndsAtTheTimeLimit) {
    EXPECT_EQ(render("", "--time-limit 1").exitCode, 3);
    EXPECT_TRUE(hasImage());
}

TEST_P(LongSample, EndsAtTheTimeLimitOfAnErrorTarget) {
    EXPECT_EQ(render("", "--target-error 1e-6 --time-limit 1").exitCode, 3);
    EXPECT_TRUE(hasImage());
}

TEST_P(LongSample, EndsAtASignal) {
    EXPECT_EQ(render("timeout --foreground --preserve-status -s INT 2", "").exitCode, 130);
    EXPECT_TRUE(hasImage());
}

INSTANTIATE_TEST_SUITE_P(Scenes, LongSample, testing::Values("lights.toml", "slow.toml"),
                         [](const auto& scene) { return std::string(scene.param).substr(0, 4); });

}  // namespace
}  // namespace rayscope
