// Whole studies of small scenes with planted flaws. Times are computed from rays where results depend on
// them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rayscope/trade.h>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/temporary_folder.h"

namespace rayscope {
namespace {

using testing::HasSubstr;

TradeRequest tradeRequest(const std::string& name, int size, double seconds) {
    Diagnostics notes;
    TradeRequest request;
    request.render.scene = std::make_shared<const SceneDescription>(loadScene(name, notes));
    request.render.camera = request.render.scene->cameras.front();
    request.render.width = request.render.height = size;
    request.render.settings.spp = 4;
    request.budgetSeconds = seconds;
    return request;
}

const TradePoint& named(const TradeResult&& result, const std::string& name) = delete;
const TradePoint& named(const TradeResult& result, const std::string& name) {
    const auto found = std::find_if(result.points.begin(), result.points.end(),
                                    [&](const TradePoint& p) { return p.name == name; });
    if (found == result.points.end()) throw std::runtime_error("no point " + name);
    return *found;
}

/// Doubles the budget until there are enough blocks for narrow intervals, so that the result does not depend
/// on the speed of the machine.
TradeResult measuredInBlocks(TradeRequest request, int fewestBlocks) {
    for (;; request.budgetSeconds *= 2.0) {
        TradeResult result = measureTrade(request);
        if (result.blocks >= fewestBlocks || request.budgetSeconds > 100.0) return result;
    }
}

TEST(Trade, FindsPlantedBiasAndPlantedDominatedSettings) {
    TradeRequest request = tradeRequest("builtin:cornell", 32, 4.0);
    Settings shallow = request.render.settings, wasteful = request.render.settings;
    shallow.maxDepth = 0;   // the mirror shows nothing
    wasteful.maxDepth = 0;  // biased as well, with many samples and without a BVH
    wasteful.bvh = false;
    wasteful.spp = 64;
    request.extra = {{"planted bias", shallow}, {"planted waste", wasteful}};
    request.secondsOfRays = [](std::uint64_t rays) { return 1e-7 * static_cast<double>(rays); };
    const TradeResult result = measuredInBlocks(request, 6);
    ASSERT_TRUE(result.complete);

    EXPECT_TRUE(named(result, "planted bias").biased);
    // One interval in forty begins above 0 by chance; its lower end is then far below the planted bias.
    EXPECT_GT(named(result, "planted bias").bias.lower, 10.0 * named(result, "base").bias.lower);
    EXPECT_NE(named(result, "planted waste").dominatedBy, "");
    EXPECT_FALSE(named(result, "planted waste").onParetoFront);
}

TEST(Trade, RecommendationsAreReproducible) {
    const TradeResult result = measureTrade(tradeRequest("builtin:cornell-area", 24, 4.0));
    ASSERT_FALSE(result.advice.empty());
    const TradePoint& advised = result.points[result.advice.front().point];

    // The same settings once more, with other seeds: a fresh measurement, in which they are the base.
    TradeRequest again = tradeRequest("builtin:cornell-area", 24, 2.0);
    again.extra = {{"advised", advised.settings}};
    const TradeResult second = measureTrade(again);
    const TradePoint& repeated = named(second, "advised");
    // Both intervals contain the true error with 95 %, so a factor of two is an error of the program.
    EXPECT_LT(repeated.error.lower, 2.0 * advised.predictedError.upper);
    EXPECT_GT(repeated.error.upper, 0.5 * advised.predictedError.lower);
    EXPECT_THAT(renderArguments(result, advised), HasSubstr("--size 24x24"));
    EXPECT_THAT(renderArguments(result, advised), testing::Not(HasSubstr("segment_samples")))
        << "there is none";
}

TEST(Trade, EffectsExcludedByTheSceneGiveIdenticalPictures) {
    const TradeResult result = measureTrade(tradeRequest("builtin:cornell", 8, 6.0));
    ASSERT_TRUE(result.complete);
    int excluded = 0;
    for (const TradeEffect& effect : result.effects) {
        const TradePoint& point = result.points[effect.point];
        if (effect.reason.empty() || point.runs == 0) continue;
        EXPECT_TRUE(point.samePicture) << effect.key << ": " << effect.reason;
        ++excluded;
    }
    EXPECT_GE(excluded, 4);
}

TEST(Trade, CountsTheWorkOfEachCandidate) {
    TradeRequest request = tradeRequest("builtin:cornell", 16, 2.0);
    Settings plain = request.render.settings;
    plain.bvh = false;
    request.extra = {{"no tree", plain}};
    const TradeResult result = measureTrade(request);
    const TradeWork& base = named(result, "base").work;
    const TradeWork& again = named(result, "base repeated").work;
    const TradeWork& noTree = named(result, "no tree").work;
    EXPECT_EQ(base.samples, static_cast<std::uint64_t>(named(result, "base").settings.spp) * 16 * 16);
    EXPECT_GT(base.rays, base.samples) << "shadow rays and reflections, too";
    EXPECT_EQ(base.rays, again.rays);
    EXPECT_EQ(base.nodesPerRay, again.nodesPerRay);
    EXPECT_EQ(base.testsPerRay, again.testsPerRay);
    EXPECT_GT(base.nodesPerRay, 1.0);
    EXPECT_GT(noTree.testsPerRay, 2.0 * base.testsPerRay);
    EXPECT_EQ(noTree.samples, 4u * 16 * 16);
}

TEST(Trade, TooShortBudgetIsReported) {
    const TradeResult result = measureTrade(tradeRequest("builtin:cornell-area", 400, 0.1));
    EXPECT_FALSE(result.complete);
    ASSERT_FALSE(result.remarks.empty());
    EXPECT_THAT(result.remarks.front(), HasSubstr("too short"));
    EXPECT_THAT(tradeHtml(result), HasSubstr("too short"));
    EXPECT_NO_THROW(nlohmann::json::parse(tradeJson(result)));
}

TEST(Trade, KeepsResultsAfterAStop) {
    TradeRequest request = tradeRequest("builtin:cornell", 24, 1000.0);
    std::stop_source stop;
    request.stop = stop.get_token();
    int reports = 0;
    request.progress = [&](const TradeProgress& progress) {
        EXPECT_GE(progress.fraction, 0.0);
        EXPECT_LE(progress.fraction, 1.0);
        if (++reports == 4) stop.request_stop();
    };
    const TradeResult result = measureTrade(request);
    EXPECT_TRUE(result.interrupted);
    EXPECT_NO_THROW(nlohmann::json::parse(tradeJson(result)));
}

TEST(Trade, ReferencesAreCachedAndExtended) {
    const test::TemporaryFolder folder;
    TradeRequest request = tradeRequest("builtin:cornell", 24, 1.0);
    request.cacheFolder = folder.file("cache");
    const TradeResult first = measureTrade(request), second = measureTrade(request);
    EXPECT_FALSE(first.reference.fromCache);
    EXPECT_TRUE(second.reference.fromCache);
    EXPECT_GE(second.reference.samples, first.reference.samples);
    request.render.settings.spp = 2;
    EXPECT_TRUE(measureTrade(request).reference.fromCache)
        << "the reference does not depend on samples per pixel";
    request.cacheFolder = "/proc/nowhere";
    EXPECT_THAT(measureTrade(request).remarks, testing::Contains(HasSubstr("was not saved")));
}

TEST(Trade, ReportsAreComplete) {
    const TradeResult result = measureTrade(tradeRequest("builtin:cornell", 24, 2.0));
    const nlohmann::json json = nlohmann::json::parse(tradeJson(result));
    EXPECT_EQ(json["points"][0]["role"], "base");
    for (const char* key : {"seconds", "rmse", "noise", "bias", "time_ratio", "efficiency_ratio"})
        EXPECT_TRUE(json["points"][0][key].contains("upper")) << key;
    EXPECT_EQ(json["points"][0]["settings"].size(), settingKeys().size());
    EXPECT_GT(json["reference"]["samples_per_half"], 0);
    for (const char* key : {"samples", "rays", "nodes_per_ray", "tests_per_ray"})
        EXPECT_GT(json["points"][0][key], 0) << key;
    const std::string csv = tradeCsv(result), html = tradeHtml(result);
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), json["points"].size() + 1);
    for (const char* part : {"<svg", "Recommended settings", "Effects in this scene",
                             "Parameter by parameter", "rayscope render "})
        EXPECT_THAT(html, HasSubstr(part));
    for (const char* outside : {"src=", "href=", "@import", "url("})
        EXPECT_EQ(html.find(outside), std::string::npos) << outside;
}

}  // namespace
}  // namespace rayscope
