// `rayscope cast` against the library's own single queries and against closed forms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rayscope/accel.h>
#include <cmath>
#include <cstring>
#include <random>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

template <class T>
std::string bytesOf(const std::vector<T>& records) {
    return {reinterpret_cast<const char*>(records.data()), records.size() * sizeof(T)};
}

template <class T>
std::vector<T> recordsOf(const std::string& bytes) {
    std::vector<T> records(bytes.size() / sizeof(T));
    if (!records.empty()) std::memcpy(records.data(), bytes.data(), records.size() * sizeof(T));
    return records;
}

/// A triangle in the plane z = 0 with a right angle at the origin, and a unit sphere around (5, 0, 0).
void writeScene(const TemporaryFolder& folder, const std::string& more = "") {
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write(
        "s.toml",
        "version = 1\n[[mesh]]\nfile = \"t.obj\"\n[[sphere]]\ncenter = [5, 0, 0]\nradius = 1\n" + more);
}

TEST(CastCommand, HitsAreThoseOfClosedForms) {
    const TemporaryFolder folder;
    writeScene(folder);
    const std::vector<Ray> rays{
        {{0.25f, 0.5f, 3.0f}, {0, 0, -1}, 0, kInfinity},     // the triangle at t 3, u 0.25, v 0.5
        {{0.25f, 0.5f, 3.0f}, {0, 0, -2}, 0, kInfinity},     // t is in units of the direction
        {{5.0f, 0.0f, 3.0f}, {0, 0, -1}, 0, kInfinity},      // the sphere, which counts after the triangle
        {{9.0f, 9.0f, 3.0f}, {0, 0, -1}, 0, kInfinity},      // a miss
        {{0.25f, 0.5f, 3.0f}, {0, 0, -1}, 0, 2.0f},          // ends before
        {{0.25f, 0.5f, 3.0f}, {0, 0, -1}, 3.0f, kInfinity},  // starts at, exclusive
        {{NAN, 0.5f, 3.0f}, {0, 0, -1}, 0, kInfinity},      {{0.25f, 0.5f, 3.0f}, {0, 0, 0}, 0, kInfinity}};
    folder.write("rays", bytesOf(rays));
    const ProgramResult result = run(folder, "rayscope cast s.toml --rays rays -o hits");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("8 rays, 3 hits"));
    const std::string file = test::readText(folder / "hits");
    ASSERT_EQ(file.size(), rays.size() * 16);
    const std::vector<Hit> hits = recordsOf<Hit>(file);
    EXPECT_EQ(hits[0].t, 3.0f);
    EXPECT_EQ(hits[0].primitive, 0u);
    EXPECT_EQ(hits[0].u, 0.25f);
    EXPECT_EQ(hits[0].v, 0.5f);
    EXPECT_EQ(hits[1].t, 1.5f);
    EXPECT_EQ(hits[2].t, 2.0f);
    EXPECT_EQ(hits[2].primitive, 1u);
    for (std::size_t i = 3; i < rays.size(); ++i) {
        EXPECT_EQ(hits[i].primitive, kNoPrimitive) << i;
        EXPECT_EQ(hits[i].t, kInfinity) << i;
    }
    EXPECT_EQ(run(folder, "rayscope cast s.toml --rays rays -o any --any -q").exitCode, 0);
    EXPECT_EQ(test::readText(folder / "any"), std::string("\1\1\1\0\0\0\0\0", 8));
}

/// The hits of each ray in a file of `cast --all`.
std::vector<std::vector<Hit>> allHitsOf(const std::string& bytes) {
    std::vector<std::vector<Hit>> rays;
    for (std::size_t at = 0; at < bytes.size();) {
        std::uint32_t count;
        if (bytes.size() - at < sizeof count) throw std::runtime_error("cut off in a count");
        std::memcpy(&count, bytes.data() + at, sizeof count);
        at += sizeof count;
        if (bytes.size() - at < count * sizeof(Hit)) throw std::runtime_error("cut off in hits");
        rays.push_back(recordsOf<Hit>(bytes.substr(at, count * sizeof(Hit))));
        at += count * sizeof(Hit);
    }
    return rays;
}

TEST(CastCommand, AllHitsAreThoseOfClosedForms) {
    const TemporaryFolder folder;
    writeScene(folder);
    const std::vector<Ray> rays{
        {{0.25f, 0.5f, 3.0f}, {0, 0, -1}, 0, kInfinity},                // the triangle
        {{5.0f, 0.0f, 3.0f}, {0, 0, -1}, 0, kInfinity},                 // into the sphere and out of it
        {{5.0f, 0.0f, 3.0f}, {0, 0, -1}, 0, 3.0f},                      // ends inside
        {{5.0f, 0.0f, 0.0f}, {0, 0, -2}, 0, kInfinity},                 // begins inside
        {{-1.0f, -1.0f, 0.0f}, {0, 0, 1}, 0, kInfinity},                // a miss
        {{0.25f, 0.25f, 1.0f}, {4.75f, -0.25f, -1.0f}, 0, kInfinity}};  // past the triangle's edge
    folder.write("rays", bytesOf(rays));
    const ProgramResult result = run(folder, "rayscope cast s.toml --rays rays -o hits --all");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const std::vector<std::vector<Hit>> hits = allHitsOf(test::readText(folder / "hits"));
    ASSERT_EQ(hits.size(), rays.size());
    const auto distances = [&](std::size_t ray) {
        std::vector<float> t;
        for (const Hit& hit : hits[ray]) t.push_back(hit.t);
        return t;
    };
    EXPECT_THAT(distances(0), ElementsAre(3.0f));
    EXPECT_THAT(distances(1), ElementsAre(2.0f, 4.0f));
    EXPECT_THAT(distances(2), ElementsAre(2.0f));
    EXPECT_THAT(distances(3), ElementsAre(0.5f));
    EXPECT_THAT(distances(4), ElementsAre());
    EXPECT_EQ(hits[1][0].primitive, 1u);
    EXPECT_EQ(hits[1][1].primitive, 1u);
    EXPECT_THAT(result.err, HasSubstr("6 rays, " + std::to_string(5 + hits[5].size()) + " hits"));
}

TEST(CastCommand, AllHitsHaveTheSameBitsForAnyThreadsAndBvh) {
    const TemporaryFolder folder;
    std::mt19937 random(2);
    std::uniform_real_distribution<float> position(-2.0f, 2.0f), direction(-1.0f, 1.0f);
    std::vector<Ray> rays(3000);
    for (Ray& ray : rays)
        ray = {{position(random), position(random), position(random)},
               {direction(random), direction(random), direction(random)},
               0.0f,
               kInfinity};
    folder.write("rays", bytesOf(rays));
    run(folder, "rayscope cast builtin:spheres --rays rays -o one -t 1 --all");
    run(folder, "rayscope cast builtin:spheres --rays rays -o closest");
    const std::string expected = test::readText(folder / "one");
    const std::vector<std::vector<Hit>> all = allHitsOf(expected);
    const std::vector<Hit> closest = recordsOf<Hit>(test::readText(folder / "closest"));
    ASSERT_EQ(all.size(), rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(all[i].empty(), closest[i].primitive == kNoPrimitive) << i;
        if (all[i].empty()) continue;
        EXPECT_EQ(all[i][0].t, closest[i].t) << i;
        EXPECT_EQ(all[i][0].primitive, closest[i].primitive) << i;
    }
    for (const char* options : {"-t 4", "--set bvh=false", "--set bvh_layout=binary", "--set isa=scalar"}) {
        const auto result =
            run(folder, std::string("rayscope cast builtin:spheres --rays rays -o other --all ") + options);
        ASSERT_EQ(result.exitCode, 0) << result.err;
        EXPECT_EQ(test::readText(folder / "other"), expected) << options;
    }
}

TEST(CastCommand, AllAndAnyExcludeEachOther) {
    const TemporaryFolder folder;
    writeScene(folder);
    folder.write("rays", "");
    const ProgramResult result = run(folder, "rayscope cast s.toml --rays rays -o hits --all --any");
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.err, HasSubstr("--all: cannot be combined with --any"));
}

TEST(CastCommand, HitsHaveTheSameBitsForAnyThreadsAndBvh) {
    const TemporaryFolder folder;
    writeScene(folder);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> position(-2.0f, 7.0f), direction(-1.0f, 1.0f);
    std::vector<Ray> rays(5000);
    for (Ray& ray : rays)
        ray = {{position(random), position(random), position(random)},
               {direction(random), direction(random), direction(random)},
               0.0f,
               kInfinity};
    folder.write("rays", bytesOf(rays));
    run(folder, "rayscope cast s.toml --rays rays -o one -t 1");
    const std::string expected = test::readText(folder / "one");
    ASSERT_EQ(expected.size(), rays.size() * 16);
    for (const char* options :
         {"-t 4", "--set bvh=false", "--set bvh_builder=median", "--set bvh_leaf_size=64"}) {
        run(folder, std::string("rayscope cast s.toml --rays rays -o other ") + options);
        EXPECT_EQ(test::readText(folder / "other"), expected) << options;
    }
    run(folder, "rayscope cast s.toml --rays rays -o any --any");
    const std::vector<Hit> hits = recordsOf<Hit>(expected);
    const std::string any = test::readText(folder / "any");
    for (std::size_t i = 0; i < hits.size(); ++i)
        ASSERT_EQ(any[i] != 0, hits[i].primitive != kNoPrimitive) << i;
}

TEST(CastCommand, MovingPrimitivesAreAtShutterOpen) {
    const TemporaryFolder folder;
    writeScene(folder, "motion = [0, 0, 1]\n");
    folder.write("rays", bytesOf(std::vector<Ray>{{{5.0f, 0.0f, 3.0f}, {0, 0, -1}, 0, kInfinity}}));
    ASSERT_EQ(run(folder, "rayscope cast s.toml --rays rays -o hits").exitCode, 0);
    const Hit hit = recordsOf<Hit>(test::readText(folder / "hits")).at(0);
    EXPECT_EQ(hit.t, 2.0f);
    EXPECT_EQ(hit.primitive, 1u);
}

TEST(CastCommand, ReadsLongFilesInSteps) {
    const TemporaryFolder folder;
    writeScene(folder);
    constexpr std::size_t kMany = (std::size_t{1} << 20) + 12345;
    std::vector<Ray> rays(kMany, Ray{{9, 9, 3}, {0, 0, -1}, 0, kInfinity});
    rays.back() = {{0.25f, 0.5f, 3.0f}, {0, 0, -1}, 0, kInfinity};
    folder.write("rays", bytesOf(rays));
    const ProgramResult result = run(folder, "rayscope cast s.toml --rays rays -o any --any");
    EXPECT_THAT(result.err, HasSubstr(std::to_string(kMany) + " rays, 1 occluded"));
    const std::string any = test::readText(folder / "any");
    ASSERT_EQ(any.size(), kMany);
    EXPECT_EQ(any.back(), 1);
    // The length of a pipe is unknown in advance.
    EXPECT_EQ(run(folder, std::string("head -c 320 rays | '") + RAYSCOPE_PROGRAM +
                              "' cast s.toml --rays /dev/stdin -o ten")
                  .exitCode,
              0);
    EXPECT_EQ(test::readText(folder / "ten").size(), 160u);
    EXPECT_EQ(run(folder, std::string("head -c 321 rays | '") + RAYSCOPE_PROGRAM +
                              "' cast s.toml --rays /dev/stdin -o eleven")
                  .exitCode,
              2);
    EXPECT_FALSE(std::filesystem::exists(folder / "eleven"));
}

TEST(CastCommand, RejectsInvalidRayFiles) {
    const TemporaryFolder folder;
    writeScene(folder);
    folder.write("odd", std::string(33, 'x'));
    folder.write("empty", "");
    const ProgramResult odd = run(folder, "rayscope cast s.toml --rays odd -o hits");
    EXPECT_EQ(odd.exitCode, 2);
    EXPECT_THAT(odd.err, HasSubstr("odd: error: not a ray file: its size of 33 bytes"));
    EXPECT_EQ(run(folder, "rayscope cast s.toml --rays missing -o hits").exitCode, 2);
    EXPECT_EQ(run(folder, "rayscope cast s.toml --rays . -o hits").exitCode, 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "hits"));
    EXPECT_EQ(run(folder, "rayscope cast s.toml --rays empty -o hits").exitCode, 0);
    EXPECT_EQ(test::readText(folder / "hits"), "");
    EXPECT_EQ(run(folder, "rayscope cast s.toml --rays empty -o nowhere/hits").exitCode, 2);
    EXPECT_EQ(run(folder, "rayscope cast s.toml -o hits").exitCode, 1);
}

}  // namespace
}  // namespace rayscope
