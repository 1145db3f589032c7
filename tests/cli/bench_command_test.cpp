#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <fstream>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;

nlohmann::json benchRows(const TemporaryFolder& folder, const std::string& arguments) {
    const ProgramResult result =
        run(folder, "rayscope bench --size 24 --rounds 5 --json rows.json " + arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    std::ifstream file(folder / "rows.json");
    return nlohmann::json::parse(file);
}

TEST(Bench, MeasuresEveryKindOfRay) {
    const TemporaryFolder folder;
    const nlohmann::json rows = benchRows(folder, "builtin:monkey builtin:spheres -t 1");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["scene"], "builtin:monkey");
    EXPECT_EQ(rows[0]["triangles"], 960);
    EXPECT_EQ(rows[0]["threads"], 1);
    EXPECT_EQ(rows[0]["builder"], "sah_binned");
    EXPECT_EQ(rows[0]["layout"], "wide");
    EXPECT_NE(rows[0]["isa"], "auto");
    EXPECT_GT(rows[1]["spheres"], 0);
    for (const nlohmann::json& row : rows) {
        EXPECT_GT(row["build_ms"], 0.0);
        EXPECT_GT(row["sah_cost"], 0.0);
        EXPECT_GT(row["bytes_per_triangle"], 0.0);
        EXPECT_NEAR(row["counted_cost"].get<double>() / row["sah_cost"].get<double>(), 1.0, 0.05);
        EXPECT_EQ(row["mismatches"], 0);
        for (const char* kind : {"primary", "shadow", "bounce", "ao"}) {
            EXPECT_GT(row["rays"][kind]["mrays_per_s"], 0.0) << kind;
            EXPECT_GT(row["rays"][kind]["batched_mrays_per_s"], 0.0) << kind;
            const nlohmann::json& counts = row["rays"][kind]["per_ray"];
            EXPECT_GT(counts["nodes"].get<double>() + counts["leaves"].get<double>(), 0.5) << kind;
            EXPECT_GE(counts["primitives"], counts["exact_tests"]) << kind;
        }
        const nlohmann::json& picture = row["picture"];
        EXPECT_EQ(picture["width"], 24);
        EXPECT_GE(picture["rays"].get<int>(), 24 * 24 * picture["samples"].get<int>());
        EXPECT_GT(picture["picture_mrays_per_s"], 0.0);
        EXPECT_GT(picture["queries_mrays_per_s"], 0.0);
        EXPECT_GT(picture["share"], 0.0);
    }
}

TEST(Bench, UsesSettings) {
    const TemporaryFolder folder;
    const nlohmann::json rows =
        benchRows(folder, "builtin:monkey -t 2 --set bvh_builder=median --set bvh_layout=binary");
    EXPECT_EQ(rows[0]["builder"], "median");
    EXPECT_EQ(rows[0]["layout"], "binary");
    EXPECT_EQ(rows[0]["threads"], 2);
    EXPECT_EQ(benchRows(folder, "builtin:monkey --set isa=scalar")[0]["isa"], "scalar");
}

}  // namespace
}  // namespace rayscope
