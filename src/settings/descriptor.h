#pragma once
// The vocabulary of the settings table: one descriptor per field of Settings.
#include <rayscope/settings.h>
#include <array>
#include <span>
#include <string_view>

namespace rayscope::settings {

/// What every descriptor says, whatever its type.
struct SettingText {
    std::string_view key;    ///< in files and on the command line
    std::string_view group;  ///< heading in the window and in the documentation
    std::string_view label;
    std::string_view help;  ///< one full sentence
    std::string_view unit = "";
    Trade trade = Trade::Nothing;
};

/// Why a setting has no effect at present, or an empty text if it has one.
using InactiveReason = std::string_view (*)(const Settings&);
constexpr std::string_view alwaysActive(const Settings&) { return {}; }

struct Toggle {
    SettingText text;
    bool Settings::*member;
    Invalidates invalidates;
    InactiveReason inactive = alwaysActive;
};

template <class T>
struct Range {
    SettingText text;
    T Settings::*member;
    T lowest, highest;
    Invalidates invalidates;
    InactiveReason inactive = alwaysActive;
    bool logarithmic = false;  ///< a slider should move by factors
};

template <class E, std::size_t N>
struct Choice {
    SettingText text;
    E Settings::*member;
    std::array<std::string_view, N> names;  ///< in the order of the enumerators
    Invalidates invalidates;
    InactiveReason inactive = alwaysActive;
};

}  // namespace rayscope::settings
