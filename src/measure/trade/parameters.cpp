#include "measure/trade/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "settings/table.h"

namespace rayscope::measure {

namespace {

std::vector<std::string> levelsOf(const settings::Toggle&, const Settings&) { return {"false", "true"}; }

template <class E, std::size_t N>
std::vector<std::string> levelsOf(const settings::Choice<E, N>& row, const Settings&) {
    return {row.names.begin(), row.names.end()};
}

/// Derived from the table, so that new settings are included: every integer that trades noise is a count of
/// samples.
template <class Row>
ParameterMeaning meaningOf(const Row& row) {
    if constexpr (std::is_same_v<Row, settings::Range<int>>) {
        if (row.member == &Settings::spp) return ParameterMeaning::SamplesPerPixel;
        if (row.member == &Settings::maxDepth) return ParameterMeaning::MaxDepth;
        if (row.text.trade == Trade::Noise) return ParameterMeaning::SplitCount;
    }
    return ParameterMeaning::Other;
}

template <class T>
std::vector<std::string> levelsOf(const settings::Range<T>& row, const Settings& settings) {
    const bool pixels = meaningOf(row) == ParameterMeaning::SamplesPerPixel;
    const T highest = std::min<T>(row.highest, pixels ? T(4096) : T(64));
    std::set<T> numbers{settings.*row.member};
    if (row.lowest <= T(0)) numbers.insert(T(0));
    for (T number = 1; number <= highest; number = static_cast<T>(number * 2))
        if (number >= row.lowest) numbers.insert(number);
    std::vector<std::string> levels;
    levels.reserve(numbers.size());
    for (const T number : numbers) levels.push_back(fmt::format("{}", number));
    return levels;
}

template <class Row>
std::string reasonForNoEffect(const Row& row, const SceneRequirements& scene, const Settings& settings) {
    const std::string_view byScene = inactiveReason(scene, row.text.key);
    return std::string(byScene.empty() ? row.inactive(settings) : byScene);
}

}  // namespace

std::vector<Parameter> parametersOf(const SceneRequirements& scene, const Settings& settings) {
    std::vector<Parameter> parameters;
    settings::forEachSetting([&](const auto& row) {
        if (row.text.trade == Trade::Nothing || !reasonForNoEffect(row, scene, settings).empty()) return;
        parameters.push_back({std::string(row.text.key), meaningOf(row), levelsOf(row, settings)});
    });
    return parameters;
}

std::vector<Effect> effectsOf(const SceneRequirements& scene, const Settings& settings) {
    std::vector<Effect> effects;
    settings::forEachSetting([&](const auto& row) {
        if constexpr (std::is_same_v<std::decay_t<decltype(row)>, settings::Toggle>) {
            if (row.invalidates != Invalidates::Film || row.text.trade == Trade::Speed) return;
            effects.push_back({row.text.key, row.text.label, settings.*row.member,
                               reasonForNoEffect(row, scene, settings)});
        }
    });
    return effects;
}

}  // namespace rayscope::measure
