#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST(LabCommand, PrintsTheRangeWithoutFailuresOfAScene) {
    const TemporaryFolder folder;
    const ProgramResult result = run(folder, "rayscope lab builtin:monkey --quick --rays 100 -o report");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("passes from 2^-40 to 2^40 times its size"));
    EXPECT_THAT(result.out, HasSubstr("fails for the untransformed scene"));
    for (const char* file : {"lab.html", "lab.csv"})
        EXPECT_FALSE(test::readText(folder / "report" / file).empty()) << file;
    const auto report = nlohmann::json::parse(test::readText(folder / "report" / "lab.json"));
    EXPECT_EQ(report["cells"].size(), 20u);
    EXPECT_EQ(report["ranges"]["rayscope"]["failing_cells"], 0);
    EXPECT_GT(report["ranges"]["float"]["failing_cells"], 0);
}

TEST(LabCommand, WritesRayFilesForCast) {
    const TemporaryFolder folder;
    const ProgramResult result = run(folder, "rayscope lab builtin:monkey --quick --rays 200 -o report");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const std::size_t at = result.err.find("rayscope cast");
    ASSERT_NE(at, std::string::npos);
    const ProgramResult cast = run(folder, result.err.substr(at, result.err.find('\n', at) - at));
    EXPECT_EQ(cast.exitCode, 0) << cast.err;
    const std::string hits = test::readText(folder / "report" / "float.hits");
    const std::string rays = test::readText(folder / "report" / "float.rays");
    EXPECT_FALSE(rays.empty());
    EXPECT_EQ(hits.size() * 2, rays.size());
}

TEST(LabCommand, PrintsJsonAndUsesSettings) {
    const TemporaryFolder folder;
    const std::string command = "rayscope lab --quick --rays 20 --json -q";
    const auto best = nlohmann::json::parse(run(folder, command).out);
    auto binary = nlohmann::json::parse(run(folder, command + " -D bvh_layout=binary").out);
    EXPECT_EQ(best["scene"], "shapes");
    EXPECT_EQ(best["cells"], binary["cells"]) << "hits do not depend on the layout";
    EXPECT_NE(nlohmann::json::parse(run(folder, command + " --seed 1").out)["cells"], best["cells"]);
}

TEST(LabCommand, KeepsResultsWhenInterrupted) {
    const TemporaryFolder folder;
    const ProgramResult result =
        run(folder, std::string("timeout --foreground --preserve-status -s INT 2 '") + RAYSCOPE_PROGRAM +
                        "' lab --rays 3000000 -o report --progress json");
    EXPECT_EQ(result.exitCode, 130) << result.err;
    EXPECT_THAT(result.err, HasSubstr("\"remaining_s\":"));
    EXPECT_TRUE(nlohmann::json::parse(test::readText(folder / "report" / "lab.json"))["interrupted"]);
}

TEST(LabCommand, RejectsInvalidRequests) {
    const TemporaryFolder folder;
    EXPECT_EQ(run(folder, "rayscope lab --rays 0").exitCode, 1);
    EXPECT_EQ(run(folder, "rayscope lab builtin:cuba").exitCode, 2);
    EXPECT_EQ(run(folder, "rayscope lab -D bvh_layuot=wide").exitCode, 2);
    EXPECT_EQ(run(folder, "rayscope lab --quick -o /proc/report").exitCode, 2);
    folder.write("s.toml",
                 "version = 1\n[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n[material.m]\n");
    const ProgramResult spheres = run(folder, "rayscope lab s.toml");
    EXPECT_EQ(spheres.exitCode, 2);
    EXPECT_THAT(spheres.err, HasSubstr("needs triangles"));
}

}  // namespace
}  // namespace rayscope
