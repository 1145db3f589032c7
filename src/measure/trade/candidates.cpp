#include "measure/trade/candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rayscope::measure {

namespace {

/// Grows with the number of rays; only the order matters.
double nominalCost(const Settings& s) {
    const double lights = s.segmentSamples + s.parallelogramSamples * s.parallelogramSamples;
    return s.spp * (1.0 + lights) * (s.glossy ? s.glossySamples : 1) * s.lensSamples *
           (1.0 + 0.1 * s.maxDepth);
}

TradePoint candidate(TradeRole role, const Settings& base, const Settings& settings, std::string name = {}) {
    TradePoint point;
    point.role = role;
    point.settings = settings;
    point.name = name.empty() ? differenceText(base, settings) : std::move(name);
    return point;
}

void addParameters(std::vector<TradePoint>& list, const std::vector<Parameter>& parameters,
                   const Settings& base) {
    for (const Parameter& parameter : parameters) {
        for (const std::string& level : parameter.levels) {
            Settings settings = base;
            assign(settings, parameter.key, level);
            if (settings == base) continue;
            TradePoint point = candidate(TradeRole::Parameter, base, settings);
            point.parameter = parameter.key;
            point.level = level;
            list.push_back(std::move(point));
        }
    }
}

void addEffects(std::vector<TradePoint>& list, const SceneRequirements& scene, const Settings& base) {
    for (const Effect& effect : effectsOf(scene, base)) {
        Settings settings = base;
        assign(settings, effect.key, effect.on ? "false" : "true");
        TradePoint point = candidate(TradeRole::Effect, base, settings);
        point.parameter = effect.key;
        point.level = effect.on ? "false" : "true";
        list.push_back(std::move(point));
    }
}

void addPresets(std::vector<TradePoint>& list, const Settings& base, const Settings& userSettings,
                bool blurred) {
    for (const Preset& preset : presets()) {
        Settings settings = userSettings;
        applyPreset(settings, preset, blurred);
        TradePoint point = candidate(TradeRole::Preset, base, settings, "preset " + std::string(preset.name));
        point.level = preset.name;
        list.push_back(std::move(point));
    }
}

/// Every combination of samples per pixel with a few counts of samples per pixel sample and a few depths.
void addCombinations(std::vector<TradePoint>& list, const std::vector<Parameter>& parameters,
                     const Settings& base) {
    std::vector<Settings> variants{base};
    const auto multiply = [&](const std::string& key, const std::vector<std::string>& levels) {
        std::vector<Settings> more;
        for (const Settings& variant : variants) {
            for (const std::string& level : levels) {
                Settings settings = variant;
                assign(settings, key, level);
                if (std::find(more.begin(), more.end(), settings) == more.end()) more.push_back(settings);
            }
        }
        variants = std::move(more);
    };
    const auto splitCounts = std::count_if(parameters.begin(), parameters.end(), [](const Parameter& p) {
        return p.meaning == ParameterMeaning::SplitCount;
    });
    for (const Parameter& parameter : parameters) {
        const std::string present = textOf(base, parameter.key);
        switch (parameter.meaning) {
            case ParameterMeaning::SamplesPerPixel:
                multiply(parameter.key, parameter.levels);
                break;
            case ParameterMeaning::SplitCount:
                multiply(parameter.key, splitCounts == 1 ? std::vector<std::string>{"1", "2", "4", present}
                                                         : std::vector<std::string>{"1", present});
                break;
            case ParameterMeaning::MaxDepth:
                multiply(parameter.key, {"1", "2", present});
                break;
            case ParameterMeaning::Other:
                break;
        }
    }
    const auto known = [&](const Settings& settings) {
        return std::any_of(list.begin(), list.end(),
                           [&](const TradePoint& p) { return p.settings == settings; });
    };
    for (const Settings& settings : variants)
        if (!known(settings)) list.push_back(candidate(TradeRole::Combination, base, settings));
}

}  // namespace

std::string differenceText(const Settings& base, const Settings& settings) {
    std::string text;
    for (const std::string_view key : settingKeys()) {
        const std::string value = textOf(settings, key);
        if (value != textOf(base, key)) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key, value);
    }
    return text.empty() ? "base" : text;
}

std::vector<TradePoint> candidatesFor(const SceneRequirements& scene, const Settings& base,
                                      const TradeRequest& request) {
    const std::vector<Parameter> parameters = parametersOf(scene, base);
    std::vector<TradePoint> list{candidate(TradeRole::Base, base, base),
                                 candidate(TradeRole::Control, base, base, "base repeated")};
    for (const auto& [name, settings] : request.extra)
        list.push_back(candidate(TradeRole::Extra, base, settings, name));
    const auto sortByCost = [&](std::size_t from) {
        std::stable_sort(list.begin() + static_cast<std::ptrdiff_t>(from), list.end(),
                         [](const TradePoint& a, const TradePoint& b) {
                             return nominalCost(a.settings) < nominalCost(b.settings);
                         });
    };
    const std::size_t first = list.size();
    addPresets(list, base, request.render.settings, blursPixels(scene, request.render.camera));
    if (request.render.settings != base)
        list.push_back(candidate(TradeRole::UserSettings, base, request.render.settings));
    addEffects(list, scene, base);
    addParameters(list, parameters, base);
    sortByCost(first);
    const std::size_t combinations = list.size();
    addCombinations(list, parameters, base);
    sortByCost(combinations);
    return list;
}

}  // namespace rayscope::measure
