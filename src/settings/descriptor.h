#pragma once
// Row types of the settings table.
#include <rayscope/settings.h>
#include <array>
#include <span>
#include <string_view>

namespace rayscope::settings {

/// The texts of a row.
struct SettingText {
    std::string_view key;    ///< name in files and on the command line
    std::string_view group;  ///< heading in the window and in the documentation
    std::string_view label;  ///< name in the window
    std::string_view help;   ///< full sentences
    std::string_view unit = "";
    Trade trade = Trade::Nothing;
};

/// Why the current values of other settings make this one ineffective; empty if it has an effect.
using InactiveReason = std::string_view (*)(const Settings&);
constexpr std::string_view alwaysActive(const Settings&) { return {}; }

/// A boolean.
struct Toggle {
    SettingText text;
    bool Settings::*member;
    Invalidates invalidates;
    InactiveReason inactive = alwaysActive;
};

/// A number from lowest to highest, both included.
template <class T>
struct Range {
    SettingText text;
    T Settings::*member;
    T lowest, highest;
    Invalidates invalidates;
    InactiveReason inactive = alwaysActive;
    bool logarithmic = false;  ///< for sliders
};

/// An enumerator by name.
template <class E, std::size_t N>
struct Choice {
    SettingText text;
    E Settings::*member;
    std::array<std::string_view, N> names;  ///< in the order of the enumerators
    Invalidates invalidates;
    InactiveReason inactive = alwaysActive;
};

}  // namespace rayscope::settings
