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

/// Keeps references in the test's own folder.
const std::string kProgram = std::string("XDG_CACHE_HOME=\"$PWD/cache\" '") + RAYSCOPE_PROGRAM + "' trade ";

TEST(TradeCommand, WritesReportsAndRecommendsValidCommands) {
    const TemporaryFolder folder;
    const ProgramResult result = run(folder, kProgram + "builtin:cornell --size 24x24 --budget 2 -o report");
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("reference: 2 x "));
    for (const char* file : {"trade.json", "trade.csv", "trade.html"})
        EXPECT_FALSE(test::readText(folder / "report" / file).empty()) << file;
    EXPECT_FALSE(std::filesystem::is_empty(folder / "cache" / "rayscope" / "references"));

    const std::size_t at = result.out.find("rayscope render");
    ASSERT_NE(at, std::string::npos);
    std::string command = result.out.substr(at, result.out.find('\n', at) - at);
    command.replace(command.find("OUT"), 3, "advised.exr");
    EXPECT_EQ(run(folder, command).exitCode, 0) << command;
    EXPECT_TRUE(std::filesystem::exists(folder / "advised.exr"));
}

/// The RMSE that `rayscope compare` finds between two pictures.
double rmseBetween(const TemporaryFolder& folder, const std::string& a, const std::string& b) {
    return nlohmann::json::parse(run(folder, "rayscope compare " + a + " " + b + " --json").out)["rmse"];
}

TEST(TradeCommand, RecommendationsAreReproducedWithinTheStatedInterval) {
    const TemporaryFolder folder;
    const ProgramResult result =
        run(folder, kProgram + "builtin:cornell-area --size 24x24 --budget 4 --json");
    const nlohmann::json report = nlohmann::json::parse(result.out);
    run(folder,
        "rayscope render builtin:cornell-area --size 24x24 --preset reference --spp 4096 -q -o "
        "reference.pfm");
    for (const nlohmann::json& advice : report["advice"]) {
        const auto point =
            std::find_if(report["points"].begin(), report["points"].end(),
                         [&](const nlohmann::json& p) { return p["name"] == advice["point"]; });
        ASSERT_NE(point, report["points"].end());
        if (!(*point)["judged"].get<bool>() || (*point)["runs"] < 6) continue;
        const nlohmann::json& interval = (*point)["next_rmse"];
        int within = 0;
        for (int seed = 101; seed <= 112; ++seed) {
            run(folder, "rayscope render builtin:cornell-area " + advice["arguments"].get<std::string>() +
                            " -q -o again.pfm --seed " + std::to_string(seed));
            const double error = rmseBetween(folder, "again.pfm", "reference.pfm");
            within += error >= interval["lower"].get<double>() && error <= interval["upper"].get<double>();
        }
        // The interval is estimated from few runs; it contains 95 % on average.
        EXPECT_GE(within, 8) << advice["point"];
        break;
    }
}

TEST(TradeCommand, ReportsABudgetThatIsTooShort) {
    const TemporaryFolder folder;
    const ProgramResult result = run(
        folder, kProgram + "builtin:cornell-area --size 600x600 --budget 0.1 --no-cache -o report --json");
    EXPECT_EQ(result.exitCode, 3) << result.err;
    const nlohmann::json report = nlohmann::json::parse(result.out);
    EXPECT_FALSE(report["complete"]);
    EXPECT_THAT(report["remarks"][0].get<std::string>(), HasSubstr("too short"));
    EXPECT_FALSE(std::filesystem::exists(folder / "cache"));
}

TEST(TradeCommand, KeepsResultsWhenInterrupted) {
    const TemporaryFolder folder;
    const ProgramResult result =
        run(folder, std::string("timeout --foreground --preserve-status -s INT 3 '") + RAYSCOPE_PROGRAM +
                        "' trade builtin:cornell --size 24x24 --budget 1000 --no-cache -o report -q");
    EXPECT_EQ(result.exitCode, 130) << result.err;
    EXPECT_TRUE(nlohmann::json::parse(test::readText(folder / "report" / "trade.json"))["interrupted"]);
}

TEST(TradeCommand, RejectsInvalidRequests) {
    const TemporaryFolder folder;
    EXPECT_EQ(run(folder, kProgram + "builtin:cornell --budget 0").exitCode, 1);
    EXPECT_EQ(run(folder, kProgram + "builtin:cornel").exitCode, 2);
    EXPECT_EQ(run(folder, kProgram + "builtin:cornell -o /proc/report --budget 1").exitCode, 2);
}

}  // namespace
}  // namespace rayscope
