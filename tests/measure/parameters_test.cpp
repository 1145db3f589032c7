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

SceneRequirements requirementsOfScene(const std::string& scene) {
    Diagnostics notes;
    return requirementsOf(loadScene(scene, notes));
}

std::vector<std::string> keysOf(const std::vector<measure::Parameter>& parameters) {
    std::vector<std::string> keys;
    for (const measure::Parameter& parameter : parameters) keys.push_back(parameter.key);
    return keys;
}

TEST(Parameters, OnlyThoseWithAnEffect) {
    const auto area = keysOf(measure::parametersOf(requirementsOfScene("builtin:cornell-area"), {}));
    for (const char* key : {"spp", "sampler", "parallelogram_samples", "max_depth", "bvh_builder"})
        EXPECT_THAT(area, Contains(key));
    for (const char* key :
         {"segment_samples", "lens_samples", "glossy_samples", "bloom_size", "texture_filter"})
        EXPECT_THAT(area, Not(Contains(key)));
    EXPECT_THAT(keysOf(measure::parametersOf(requirementsOfScene("builtin:spheres-dof"), {})),
                Contains("lens_samples"));
    Settings noBvh;
    noBvh.bvh = false;
    EXPECT_THAT(keysOf(measure::parametersOf(requirementsOfScene("builtin:cornell-area"), noBvh)),
                Not(Contains("bvh_builder")));
}

/// Settings that are neither parameters nor effects, and why.
const std::map<std::string_view, std::string_view> kNotMeasured{
    {"light_sample_count", "another unit of the sample counts"},
    {"reflect_when", "which materials mirror is part of the scene"},
    {"glossy_sigma", "how rough a mirror is"},
    {"lens_shape", "of the highlights out of focus"},
    {"sharp_zone", "what is in focus"},
    {"bvh_refit", "only edits refit an existing tree"},
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

TEST(Parameters, EverySettingIsAParameterOrAnEffectOrListedHere) {
    Settings everything;
    everything.glossy = everything.bloom = true;
    const SceneRequirements scene = requirementsOf(test::allEffectsScene());
    const std::vector<measure::Parameter> parameters = measure::parametersOf(scene, everything);
    const std::vector<measure::Effect> effects = measure::effectsOf(scene, everything);
    for (const std::string_view key : settingKeys()) {
        const auto parameter = std::find_if(parameters.begin(), parameters.end(),
                                            [&](const measure::Parameter& k) { return k.key == key; });
        const bool isParameter = parameter != parameters.end() && parameter->levels.size() >= 2;
        const bool isEffect = std::any_of(effects.begin(), effects.end(),
                                          [&](const measure::Effect& e) { return e.key == key; });
        EXPECT_NE(isParameter || isEffect, kNotMeasured.contains(key)) << key;
    }
    for (const auto& [key, why] : kNotMeasured) EXPECT_THAT(settingKeys(), Contains(key)) << why;
}

TEST(Parameters, LevelsArePowersOfTwoAndThePresentValue) {
    Settings settings;
    settings.maxDepth = 5;
    settings.spp = 100;
    for (const measure::Parameter& parameter :
         measure::parametersOf(requirementsOfScene("builtin:cornell"), settings)) {
        if (parameter.key == "max_depth") {
            EXPECT_THAT(parameter.levels, ElementsAre("0", "1", "2", "4", "5", "8", "16"));
        }
        if (parameter.key == "spp") {
            EXPECT_THAT(parameter.levels, Contains("100"));
        }
        if (parameter.key == "spp") {
            EXPECT_EQ(parameter.levels.back(), "4096");
        }
        const bool splits = parameter.key.ends_with("_samples");
        EXPECT_EQ(parameter.meaning == measure::ParameterMeaning::SplitCount, splits) << parameter.key;
        if (parameter.key == "bvh_builder") {
            EXPECT_GE(parameter.levels.size(), 3u);
        }
        for (const std::string& level : parameter.levels) {
            Settings other = settings;
            EXPECT_NO_THROW(assign(other, parameter.key, level)) << parameter.key << " " << level;
        }
    }
}

TEST(Effects, HaveAReasonIfTheSceneExcludesThem) {
    const std::vector<measure::Effect> effects =
        measure::effectsOf(requirementsOfScene("builtin:cornell"), {});
    const auto reasonOf = [&](std::string_view key) {
        return std::find_if(effects.begin(), effects.end(),
                            [&](const measure::Effect& e) { return e.key == key; })
            ->reason;
    };
    EXPECT_EQ(reasonOf("recursion"), "");
    EXPECT_EQ(reasonOf("depth_of_field"), "no camera of the scene has a lens");
    EXPECT_EQ(std::count_if(effects.begin(), effects.end(),
                            [](const measure::Effect& e) { return e.key == "bloom" || e.key == "bvh"; }),
              0);
}

TEST(Candidates, AreDistinctAndBeginWithBaseAndControl) {
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
        measure::candidatesFor(requirementsOfScene("builtin:cornell-area"), base, request);
    EXPECT_EQ(list[0].role, TradeRole::Base);
    EXPECT_EQ(list[1].role, TradeRole::Control);
    EXPECT_EQ(list[2].name, "planted");
    const auto user = std::find_if(list.begin(), list.end(),
                                   [](const TradePoint& p) { return p.role == TradeRole::UserSettings; });
    ASSERT_NE(user, list.end());
    EXPECT_EQ(user->name, "spp 16");
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
