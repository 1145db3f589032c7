#include "viewer/model/window_layout.h"

#include <fmt/format.h>
#include <rayscope/diagnostics.h>

#include <fstream>
#include <sstream>

#include "base/atomic_file.h"
#include "base/parse_number.h"
#include "base/user_folders.h"

namespace rayscope::viewer {

namespace {

std::optional<float> numberWithin(std::string_view text, float lowest, float highest) {
    const std::optional<float> number = base::parseReal<float>(text);
    return number && *number >= lowest && *number <= highest ? number : std::nullopt;
}

void readLine(WindowLayout& layout, std::string_view line) {
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos) return;
    const std::string_view key = line.substr(0, space), value = line.substr(space + 1);
    if (key == "scale") {
        layout.scale = numberWithin(value, WindowLayout::kMinScale, WindowLayout::kMaxScale);
    } else if (key == "panel-width") {
        layout.panelWidth = numberWithin(value, WindowLayout::kMinPanelWidth, WindowLayout::kMaxPanelWidth)
                                .value_or(layout.panelWidth);
    } else if (key == "panel-side") {
        layout.panelOnLeft = value == "left";
    } else if (key == "tab") {
        layout.tab = value;
    } else if (key == "section") {
        const std::size_t state = value.rfind(' ');
        if (state != std::string_view::npos)
            layout.sections[std::string(value.substr(0, state))] = value.substr(state + 1) == "open";
    }
}

}  // namespace

std::string toText(const WindowLayout& layout) {
    std::string text = fmt::format("panel-width {}\npanel-side {}\n", layout.panelWidth,
                                   layout.panelOnLeft ? "left" : "right");
    if (layout.scale) text += fmt::format("scale {}\n", *layout.scale);
    if (!layout.tab.empty()) text += fmt::format("tab {}\n", layout.tab);
    for (const auto& [section, open] : layout.sections)
        text += fmt::format("section {} {}\n", section, open ? "open" : "closed");
    return text;
}

WindowLayout layoutFromText(std::string_view text) {
    WindowLayout layout;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        readLine(layout, text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return layout;
}

std::filesystem::path layoutPath() {
    const std::filesystem::path folder = base::userConfigFolder();
    return folder.empty() ? folder : folder / "window";
}

WindowLayout readLayout(const std::filesystem::path& file) {
    std::ostringstream text;
    if (std::ifstream stream(file); stream) text << stream.rdbuf();
    return layoutFromText(text.str());
}

void writeLayout(const std::filesystem::path& file, const WindowLayout& layout) {
    if (file.empty()) return;
    std::error_code ignored;
    std::filesystem::create_directories(file.parent_path(), ignored);
    try {
        base::writeFileAtomically(file.string(), toText(layout));
    } catch (const InputError&) {  // then it is not stored
    }
}

}  // namespace rayscope::viewer
