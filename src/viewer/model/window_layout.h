#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace rayscope::viewer {

/// What the window remembers between two starts. Lengths are in units at UI scale 1.
struct WindowLayout {
    static constexpr float kMinScale = 0.8f, kMaxScale = 4.0f;
    static constexpr float kMinPanelWidth = 240.0f, kMaxPanelWidth = 900.0f;

    std::optional<float> scale;  ///< of the user interface; none: that of the monitor
    float panelWidth = 336.0f;
    bool panelOnLeft = false;
    std::string tab;                       ///< of the side panel; empty: the first
    std::map<std::string, bool> sections;  ///< "Tab/Section": open; those that differ from the default
    bool operator==(const WindowLayout&) const = default;
};

/// One item per line: "panel-width 400", "section Scene/Lights closed".
std::string toText(const WindowLayout& layout);
/// Lines that are not understood, and numbers beyond their range, are ignored.
WindowLayout layoutFromText(std::string_view text);

/// $XDG_CONFIG_HOME/rayscope/window, or ~/.config/rayscope/window; empty if there is no home.
std::filesystem::path layoutPath();
/// The default layout if the file cannot be read.
WindowLayout readLayout(const std::filesystem::path& file);
/// If the file cannot be written, the layout is not stored; there is no error.
void writeLayout(const std::filesystem::path& file, const WindowLayout& layout);

}  // namespace rayscope::viewer
