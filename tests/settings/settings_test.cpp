#include <rayscope/settings.h>

#include <fmt/format.h>
#include <cctype>
#include <set>
#include <stdexcept>

#include "settings/table.h"
#include "support/expect_input_error.h"

namespace rayscope {
namespace {

using test::inputErrorOf;
using testing::AllOf;
using testing::HasSubstr;

/// Valid values other than the default.
std::vector<std::string> otherValues(const SettingInfo& info) {
    std::vector<std::string> values;
    const auto add = [&](std::string value) {
        if (value != info.defaultValue) values.push_back(std::move(value));
    };
    if (info.kind == "boolean") {
        add("true");
        add("false");
    }
    for (const std::string_view choice : info.choices) add(std::string(choice));
    if (info.kind == "integer") {
        add(std::to_string(static_cast<long long>(info.lowest)));
        add(std::to_string(static_cast<long long>(info.highest)));
    }
    if (info.kind == "number") {
        add("0.1");  // not representable as float: must be printed as written
        add(std::to_string(static_cast<long long>(info.highest)));
    }
    return values;
}

TEST(Settings, ValuesSurvivePrintingAndParsing) {
    for (const SettingInfo& info : describeSettings()) {
        const std::vector<std::string> values = otherValues(info);
        ASSERT_FALSE(values.empty()) << info.key;
        for (const std::string& value : values) {
            Settings settings;
            assign(settings, info.key, value);
            Settings again;
            assign(again, info.key, textOf(settings, info.key));
            EXPECT_EQ(settings, again) << info.key << " = " << value;
            EXPECT_NE(settings, Settings{}) << info.key << " = " << value;
        }
    }
}

TEST(Settings, ValuesArePrintedAsWritten) {
    Settings settings;
    assign(settings, "exposure", "0.1");
    EXPECT_EQ(textOf(settings, "exposure"), "0.1");
    assign(settings, "texture_filter", "mipmap");
    EXPECT_EQ(textOf(settings, "texture_filter"), "mipmap");
    EXPECT_EQ(settings.textureFilter, TextureFilter::Mipmap);
    assign(settings, "shading", "false");
    EXPECT_EQ(textOf(settings, "shading"), "false");
}

TEST(Settings, AssignChangesOneField) {
    for (const SettingInfo& info : describeSettings()) {
        Settings settings;
        assign(settings, info.key, otherValues(info).front());
        for (const std::string_view key : settingKeys()) {
            const bool same = textOf(settings, key) == textOf(Settings{}, key);
            EXPECT_EQ(same, key != info.key) << key << " after a change of " << info.key;
        }
    }
}

TEST(Settings, ValidValuesArePrintedShortest) {
    for (const SettingInfo& info : describeSettings()) {
        EXPECT_EQ(info.values.find('e', info.values.find(" … ")), std::string::npos)
            << info.key << ": " << info.values;
    }
    const auto valuesOf = [](std::string_view key) {
        for (const SettingInfo& info : describeSettings())
            if (info.key == key) return info.values;
        return std::string();
    };
    EXPECT_EQ(valuesOf("spp"), "1 … 1048576");
    EXPECT_EQ(valuesOf("exposure"), "-20 … 20");
    EXPECT_EQ(valuesOf("shading"), "true, false");
    EXPECT_EQ(valuesOf("bloom_filter"), "box, gaussian");
}

TEST(Settings, FieldsAreInTheOrderOfTheTable) {
    Settings settings;
    const char* last = nullptr;
    settings::forEachSetting([&](const auto& row) {
        const char* address = reinterpret_cast<const char*>(&(settings.*row.member));
        EXPECT_TRUE(last == nullptr || std::less<>{}(last, address)) << row.text.key;
        last = address;
    });
}

TEST(Settings, DefaultsAreWithinTheirRanges) {
    for (const SettingInfo& info : describeSettings()) {
        Settings settings;
        EXPECT_NO_THROW(assign(settings, info.key, info.defaultValue)) << info.key;
        EXPECT_EQ(settings, Settings{}) << info.key;
    }
}

TEST(Settings, NumbersOutOfRangeAreErrorsAndChangeNothing) {
    for (const SettingInfo& info : describeSettings()) {
        if (info.kind != "integer" && info.kind != "number") continue;
        const auto outside = {std::to_string(static_cast<long long>(info.lowest) - 1),
                              std::to_string(static_cast<long long>(info.highest) + 1000)};
        for (const std::string& value : outside) {
            Settings settings;
            EXPECT_THAT(inputErrorOf([&] { assign(settings, info.key, value); }),
                        AllOf(HasSubstr(std::string(info.key)), HasSubstr("from "), HasSubstr(value)));
            EXPECT_EQ(settings, Settings{});
        }
    }
}

TEST(Settings, InvalidTextIsAnError) {
    for (const SettingInfo& info : describeSettings()) {
        for (const char* value : {"", " ", "nan", "1x", "0x10", "99999999999999999999", "1e999", "True"}) {
            Settings settings;
            EXPECT_THAT(inputErrorOf([&] { assign(settings, info.key, value); }), HasSubstr("expected"))
                << info.key << " = " << value;
        }
    }
}

TEST(Settings, ErrorsSuggestTheNearestName) {
    Settings settings;
    EXPECT_THAT(inputErrorOf([&] { assign(settings, "max_dpeth", "3"); }),
                HasSubstr("did you mean 'max_depth'"));
    EXPECT_THAT(inputErrorOf([&] { assign(settings, "sampler", "sobel"); }),
                AllOf(HasSubstr("independent, jittered or sobol"), HasSubstr("did you mean 'sobol'")));
    EXPECT_THAT(inputErrorOf([&] { textOf(settings, "bvh_builde"); }),
                HasSubstr("did you mean 'bvh_builder'"));
}

TEST(Settings, ChangedReturnsTheMaximumOverFields) {
    const Settings defaults;
    EXPECT_EQ(changed(defaults, defaults), Invalidates::Nothing);
    Settings settings;
    settings.exposure = 1.0f;
    EXPECT_EQ(changed(defaults, settings), Invalidates::Display);
    settings.maxDepth = 1;
    EXPECT_EQ(changed(defaults, settings), Invalidates::Film);
    settings.bvhLeafSize = 1;
    EXPECT_EQ(changed(defaults, settings), Invalidates::Accel);
    EXPECT_EQ(changed(settings, defaults), Invalidates::Accel);
}

TEST(Settings, ChangedCoversEveryField) {
    settings::forEachSetting([](const auto& row) {
        EXPECT_NE(row.invalidates, Invalidates::Nothing) << row.text.key;
        const std::vector<SettingInfo> infos = describeSettings();
        for (const SettingInfo& info : infos) {
            if (info.key != row.text.key) continue;
            Settings settings;
            assign(settings, info.key, otherValues(info).front());
            EXPECT_EQ(changed(Settings{}, settings), row.invalidates) << info.key;
        }
    });
}

TEST(Settings, KeysAndLabelsAreUniqueAndHelpIsASentence) {
    std::set<std::string_view> keys, labels;
    for (const SettingInfo& info : describeSettings()) {
        EXPECT_TRUE(keys.insert(info.key).second) << info.key << " is not unique";
        EXPECT_TRUE(labels.insert(info.label).second) << info.label << " is not unique";
        for (const char c : info.key)
            EXPECT_TRUE(std::islower(static_cast<unsigned char>(c)) ||
                        std::isdigit(static_cast<unsigned char>(c)) || c == '_')
                << info.key;
        ASSERT_FALSE(info.help.empty()) << info.key;
        EXPECT_EQ(info.help.back(), '.') << info.key << ": the help is not a sentence";
        EXPECT_FALSE(info.group.empty()) << info.key;
    }
}

TEST(Settings, DocumentedKeysExist) {
    const std::vector<std::string_view> keys = settingKeys();
    for (const char* key : {"shading",
                            "recursion",
                            "max_depth",
                            "hard_shadows",
                            "soft_shadows",
                            "texture_mapping",
                            "texture_filter",
                            "normal_interpolation",
                            "environment",
                            "reflection_map",
                            "glossy",
                            "glossy_sigma",
                            "glossy_samples",
                            "transparency",
                            "transparent_shadows",
                            "depth_of_field",
                            "lens_samples",
                            "sharp_zone",
                            "motion_blur",
                            "spp",
                            "sampler",
                            "segment_samples",
                            "parallelogram_samples",
                            "bloom",
                            "bloom_filter",
                            "bloom_sigma",
                            "bloom_threshold",
                            "bloom_size",
                            "bloom_scale",
                            "bloom_debug",
                            "bvh",
                            "bvh_builder",
                            "bvh_bins",
                            "bvh_max_level",
                            "bvh_leaf_size",
                            "exposure",
                            "tone"})
        EXPECT_THAT(keys, testing::Contains(key));
}

TEST(Presets, IncreaseSamplesAndKeepOtherSettings) {
    Settings settings;
    settings.glossySigma = 7.0f;
    ASSERT_EQ(presets().size(), 4u);
    for (const bool blurred : {false, true}) {
        int samples = 0;
        for (const Preset& preset : presets()) {
            Settings result = settings;
            applyPreset(result, preset, blurred);
            EXPECT_GT(result.spp, samples) << preset.name;
            samples = result.spp;
            EXPECT_EQ(result.glossySigma, 7.0f);
            for (const SettingInfo& info : describeSettings())
                EXPECT_TRUE(info.trade == Trade::Noise || info.trade == Trade::Bias ||
                            textOf(result, info.key) == textOf(settings, info.key))
                    << preset.name << " sets " << info.key << ", which does not trade accuracy";
        }
    }
}

TEST(Presets, HaveOneSamplePerLightWherePixelsAreBlurred) {
    for (const Preset& preset : presets()) {
        Settings sharp, blurred;
        applyPreset(sharp, preset, false);
        applyPreset(blurred, preset, true);
        EXPECT_EQ(blurred.parallelogramSamples, 1) << preset.name;
        EXPECT_EQ(blurred.segmentSamples, 1) << preset.name;
        blurred.parallelogramSamples = sharp.parallelogramSamples;
        blurred.segmentSamples = sharp.segmentSamples;
        EXPECT_EQ(blurred, sharp) << "no other difference";
    }
}

TEST(Presets, AreFoundByName) {
    EXPECT_EQ(presetNamed("final").name, "final");
    EXPECT_THROW(presetNamed("finel"), InputError);
}

TEST(Settings, CheckAcceptsWhatAssignAccepts) {
    EXPECT_NO_THROW(checkSettings(Settings{}));
    Settings settings;
    for (const SettingInfo& info : describeSettings()) {
        if (info.kind != "integer" && info.kind != "number") continue;
        for (const double bound : {info.lowest, info.highest}) {
            assign(settings, info.key, fmt::format("{}", bound));
            EXPECT_NO_THROW(checkSettings(settings)) << info.key;
        }
    }
}

TEST(Settings, CheckNamesTheKeyAndTheRange) {
    Settings settings;
    settings.maxDepth = -1;
    try {
        checkSettings(settings);
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "settings: max_depth is -1; expected 0 … 16");
    }
}

}  // namespace
}  // namespace rayscope
