#include "measure/trade/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "measure/trade/candidates.h"
#include "support/all_effects_scene.h"

namespace rayscope {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

SceneRequirements needsOf(const std::string& scene) {
    Diagnostics notes;
    return requirementsOf(loadScene(scene, notes));
}

std::vector<std::string> keysOf(const std::vector<measure::Parameter>& knobs) {
    std::vector<std::string> keys;
    for (const measure::Parameter& knob : knobs) keys.push_back(knob.key);
    return keys;
}

TEST(Knobs, OnlyThoseThatCanMatter) {
    const auto area = keysOf(measure::parametersOf(needsOf("builtin:cornell-area"), {}));
    for (const char* key : {"spp", "sampler", "parallelogram_samples", "max_depth", "bvh_builder"})
        EXPECT_THAT(area, Contains(key));
    for (const char* key :
         {"segment_samples", "lens_samples", "glossy_samples", "bloom_size", "texture_filter"})
        EXPECT_THAT(area, Not(Contains(key)));
    EXPECT_THAT(keysOf(measure::parametersOf(needsOf("builtin:spheres-dof"), {})), Contains("lens_samples"));
    Settings noBvh;
    noBvh.bvh = false;
    EXPECT_THAT(keysOf(measure::parametersOf(needsOf("builtin:cornell-area"), noBvh)),
                Not(Contains("bvh_builder")));
}

/// Settings that are neither swept nor switched, and why.
const std::map<std::string_view, std::string_view> kNoTrade{
    {"light_sample_count", "another way to say the numbers of samples"},
    {"reflect_when", "which materials mirror is part of the scene"},
    {"glossy_sigma", "how rough a mirror is"},
    {"lens_shape", "of the highlights out of focus"},
    {"sharp_zone", "what is in focus"},
    {"bvh_refit", "only edits meet a tree that was built before"},
    {"isa", "auto takes the fastest kernels that the machine has"},
    {"bloom", "whether bright parts glow"},
    {"bloom_sigma", "the shape of the glow"},
    {"bloom_threshold", "what glows"},
    {"bloom_scale", "how much it glows"},
    {"bloom_debug", "a view of the parts"},
    {"bloom_stage", "a view of the parts"},
    {"exposure", "how bright the picture is"},
    {"tone", "for which screen it is"},
};

TEST(Knobs, EverySettingIsSweptOrSwitchedOrIsNoTrade) {
    Settings everything;
    everything.glossy = everything.bloom = true;
    const SceneRequirements scene = requirementsOf(test::allEffectsScene());
    const std::vector<measure::Parameter> knobs = measure::parametersOf(scene, everything);
    const std::vector<measure::Effect> effects = measure::effectsOf(scene, everything);
    for (const std::string_view key : settingKeys()) {
        const auto knob = std::find_if(knobs.begin(), knobs.end(),
                                       [&](const measure::Parameter& k) { return k.key == key; });
        const bool swept = knob != knobs.end() && knob->levels.size() >= 2;
        const bool switched = std::any_of(effects.begin(), effects.end(),
                                          [&](const measure::Effect& e) { return e.key == key; });
        EXPECT_NE(swept || switched, kNoTrade.contains(key)) << key;
    }
    for (const auto& [key, why] : kNoTrade) EXPECT_THAT(settingKeys(), Contains(key)) << why;
}

TEST(Knobs, LevelsAreThePowersOfTwoAndThePresentValue) {
    Settings settings;
    settings.maxDepth = 5;
    settings.spp = 100;
    for (const measure::Parameter& knob : measure::parametersOf(needsOf("builtin:cornell"), settings)) {
        if (knob.key == "max_depth") {
            EXPECT_THAT(knob.levels, ElementsAre("0", "1", "2", "4", "5", "8", "16"));
        }
        if (knob.key == "spp") {
            EXPECT_THAT(knob.levels, Contains("100"));
        }
        if (knob.key == "spp") {
            EXPECT_EQ(knob.levels.back(), "4096");
        }
        if (knob.key == "bvh_builder") {
            EXPECT_GE(knob.levels.size(), 3u);
        }
        for (const std::string& level : knob.levels) {
            Settings turned = settings;
            EXPECT_NO_THROW(assign(turned, knob.key, level)) << knob.key << " " << level;
        }
    }
}

TEST(Knobs, EveryEffectHasAProofOrNone) {
    const std::vector<measure::Effect> effects = measure::effectsOf(needsOf("builtin:cornell"), {});
    const auto proofOf = [&](std::string_view key) {
        return std::find_if(effects.begin(), effects.end(),
                            [&](const measure::Effect& e) { return e.key == key; })
            ->reason;
    };
    EXPECT_EQ(proofOf("recursion"), "");
    EXPECT_EQ(proofOf("depth_of_field"), "no camera of the scene has a lens");
    EXPECT_EQ(std::count_if(effects.begin(), effects.end(),
                            [](const measure::Effect& e) { return e.key == "bloom" || e.key == "bvh"; }),
              0);
}

TEST(Candidates, AreDifferentAndBeginWithTheBaseAndItsControl) {
    TradeRequest request;
    Settings planted;
    planted.bvh = false;
    request.extra = {{"planted", planted}};
    const Settings base = [] {
        Settings s;
        s.spp = 2;
        return s;
    }();
    const std::vector<TradePoint> list =
        measure::candidatesFor(needsOf("builtin:cornell-area"), base, request);
    EXPECT_EQ(list[0].role, TradeRole::Base);
    EXPECT_EQ(list[1].role, TradeRole::Control);
    EXPECT_EQ(list[2].name, "planted");
    const auto yours = std::find_if(list.begin(), list.end(),
                                    [](const TradePoint& p) { return p.role == TradeRole::UserSettings; });
    ASSERT_NE(yours, list.end());
    EXPECT_EQ(yours->name, "spp 16");
    EXPECT_EQ(std::count_if(list.begin(), list.end(),
                            [](const TradePoint& p) { return p.role == TradeRole::Preset; }),
              4);
    for (std::size_t i = 3; i < list.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(j != 1 && list[i].settings == list[j].settings && list[i].role == list[j].role)
                << list[i].name;
}

}  // namespace
}  // namespace rayscope
