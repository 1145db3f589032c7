// Visitors of the settings table: parse, print, describe, compare.
#include <fmt/format.h>

#include <rayscope/diagnostics.h>
#include <optional>

#include "base/nearest_name.h"
#include "base/parse_number.h"
#include "base/printable_text.h"
#include "settings/table.h"

namespace rayscope {

namespace {

void parse(const settings::Toggle& row, Settings& settings, std::string_view value) {
    if (value != "true" && value != "false")
        throw InputError(
            fmt::format("setting '{}': expected true or false, got {}", row.text.key, base::quoted(value)));
    settings.*row.member = value == "true";
}

template <class T>
std::optional<T> numberOf(std::string_view text) {
    if constexpr (std::is_integral_v<T>)
        return base::parseInteger<T>(text);
    else
        return base::parseReal<T>(text);
}

template <class T>
void parse(const settings::Range<T>& row, Settings& settings, std::string_view value) {
    const std::optional<T> number = numberOf<T>(value);
    if (!number || !(*number >= row.lowest && *number <= row.highest))
        throw InputError(fmt::format("setting '{}': expected {} from {} to {}, got {}", row.text.key,
                                     std::is_integral_v<T> ? "an integer" : "a number", row.lowest,
                                     row.highest, base::quoted(value)));
    settings.*row.member = *number;
}

template <class E, std::size_t N>
void parse(const settings::Choice<E, N>& row, Settings& settings, std::string_view value) {
    for (std::size_t i = 0; i < N; ++i) {
        if (row.names[i] != value) continue;
        settings.*row.member = static_cast<E>(i);
        return;
    }
    throw InputError(fmt::format("setting '{}': expected {}, got {}{}", row.text.key,
                                 base::joinChoices(row.names), base::quoted(value),
                                 base::didYouMean(value, row.names)));
}

std::string print(const settings::Toggle& row, const Settings& settings) {
    return settings.*row.member ? "true" : "false";
}
template <class T>
std::string print(const settings::Range<T>& row, const Settings& settings) {
    return fmt::format("{}", settings.*row.member);
}
template <class E, std::size_t N>
std::string print(const settings::Choice<E, N>& row, const Settings& settings) {
    return std::string(row.names[static_cast<std::size_t>(settings.*row.member)]);
}

void describeKind(const settings::Toggle&, SettingInfo& info) {
    info.kind = "boolean";
    info.values = "true, false";
}
template <class T>
void describeKind(const settings::Range<T>& row, SettingInfo& info) {
    info.kind = std::is_integral_v<T> ? "integer" : "number";
    info.lowest = static_cast<double>(row.lowest);
    info.highest = static_cast<double>(row.highest);
    info.values = fmt::format("{} … {}", row.lowest, row.highest);
}
template <class E, std::size_t N>
void describeKind(const settings::Choice<E, N>& row, SettingInfo& info) {
    info.kind = "choice";
    info.choices.assign(row.names.begin(), row.names.end());
    info.values = fmt::format("{}", fmt::join(info.choices, ", "));
}

[[noreturn]] void throwUnknown(std::string_view key) {
    const auto keys = settingKeys();
    throw InputError(fmt::format("unknown setting {}{}", base::quoted(key), base::didYouMean(key, keys)));
}

}  // namespace

std::vector<std::string_view> settingKeys() {
    std::vector<std::string_view> keys;
    settings::forEachSetting([&](const auto& row) { keys.push_back(row.text.key); });
    return keys;
}

Invalidates changed(const Settings& a, const Settings& b) {
    Invalidates result = Invalidates::Nothing;
    settings::forEachSetting([&](const auto& row) {
        if (a.*row.member != b.*row.member) result = std::max(result, row.invalidates);
    });
    return result;
}

Settings withDisplayOf(const Settings& traced, const Settings& display) {
    Settings result = traced;
    settings::forEachSetting([&](const auto& row) {
        if (row.invalidates <= Invalidates::Display) result.*row.member = display.*row.member;
    });
    return result;
}

void assign(Settings& settings, std::string_view key, std::string_view value) {
    bool known = false;
    settings::forEachSetting([&](const auto& row) {
        if (row.text.key != key) return;
        known = true;
        parse(row, settings, value);
    });
    if (!known) throwUnknown(key);
}

std::string textOf(const Settings& settings, std::string_view key) {
    std::string text;
    bool known = false;
    settings::forEachSetting([&](const auto& row) {
        if (row.text.key != key) return;
        known = true;
        text = print(row, settings);
    });
    if (!known) throwUnknown(key);
    return text;
}

std::vector<SettingInfo> describeSettings() {
    std::vector<SettingInfo> list;
    const Settings defaults;
    settings::forEachSetting([&](const auto& row) {
        SettingInfo info;
        info.key = row.text.key;
        info.group = row.text.group;
        info.label = row.text.label;
        info.help = row.text.help;
        info.unit = row.text.unit;
        info.trade = row.text.trade;
        info.defaultValue = print(row, defaults);
        describeKind(row, info);
        list.push_back(std::move(info));
    });
    return list;
}

}  // namespace rayscope
