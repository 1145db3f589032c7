#include "viewer/panels/items.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/atomic_file.h"

namespace rayscope::viewer::ui {

namespace {

/// A scope, and the section in it that was opened last.
struct Level {
    std::string name, section;
};

bool recording = false;
std::vector<Item> recorded;
std::vector<Level> levels(1);
std::string row;
std::map<std::string, bool> changedSections;
std::string drawnTab, wantedTab;

std::string pathOf(std::string_view label) {
    std::string path;
    for (const Level& level : levels) {
        if (!level.name.empty()) path += level.name + "/";
        if (!level.section.empty()) path += level.section + "/";
    }
    if (label.starts_with("##")) path += row;
    return path.append(label);
}

}  // namespace

void closeOnEscape() {
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) ImGui::CloseCurrentPopup();
}

void recordItems(bool on) { recording = on; }

void beginFrame() {
    recorded.clear();
    levels.assign(1, {});
    row.clear();
}

const std::vector<Item>& items() { return recorded; }

void note(const char* label, bool isText, bool enabled) {
    if (!recording) return;
    const ImVec2 lower = ImGui::GetItemRectMin(), upper = ImGui::GetItemRectMax();
    const ImVec2 clipLower = ImGui::GetWindowDrawList()->GetClipRectMin(),
                 clipUpper = ImGui::GetWindowDrawList()->GetClipRectMax();
    Item item{pathOf(label),
              {std::max(lower.x, clipLower.x), std::max(lower.y, clipLower.y)},
              {std::min(upper.x, clipUpper.x), std::min(upper.y, clipUpper.y)}};
    item.isText = isText;
    item.enabled = enabled && ImGui::GetStyle().Alpha > 0.9f;  // BeginDisabled() fades
    item.visible = item.upper.x > item.lower.x && item.upper.y > item.lower.y;
    recorded.push_back(std::move(item));
}

void noteText(std::string_view text) {
    if (recording) note(std::string(text).c_str(), true);
}

void noteArea(const char* label, ImVec2 lower, ImVec2 upper) {
    if (recording) recorded.push_back({pathOf(label), lower, upper});
}

void noteRow(std::string_view label) {
    if (recording) row = label;
}

Scope::Scope(std::string_view name) {
    if (recording) levels.push_back({std::string(name), ""});
}

Scope::~Scope() {
    if (recording && levels.size() > 1) levels.pop_back();
}

std::map<std::string, bool>& sections() { return changedSections; }
const std::string& currentTab() { return drawnTab; }
void selectTab(std::string_view name) { wantedTab = name; }

bool finiteEdit(std::span<float> values, const std::function<bool()>& draw) {
    const std::vector<float> before(values.begin(), values.end());
    const bool edited = draw();
    if (std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); }))
        return edited;
    std::copy(before.begin(), before.end(), values.begin());
    return false;
}

bool section(const char* label, ImGuiTreeNodeFlags flags) {
    const std::string key = drawnTab + "/" + label;
    const bool openByDefault = (flags & ImGuiTreeNodeFlags_DefaultOpen) != 0;
    const auto changed = changedSections.find(key);
    ImGui::SetNextItemOpen(changed != changedSections.end() ? changed->second : openByDefault);
    const bool open = ImGui::CollapsingHeader(label, flags);
    if (open == openByDefault)
        changedSections.erase(key);
    else
        changedSections[key] = open;
    if (!recording) return open;
    levels.back().section.clear();
    note(label);
    levels.back().section = label;
    return open;
}

bool treeNode(const char* label) { return noted(label, ImGui::TreeNode(label)); }

void combo(const char* label, const char* shown, const std::function<void()>& draw, ImGuiComboFlags flags) {
    const bool open = ImGui::BeginCombo(label, shown, flags);
    if (!open) return note(label);
    {
        // The list is the current window now; the item of the closed list cannot be queried any more.
        const Scope scope(row);
        draw();
        closeOnEscape();
    }
    ImGui::EndCombo();
}

void menu(const char* label, const std::function<void()>& draw, bool enabled) {
    const bool open = ImGui::BeginMenu(label, enabled);
    if (!open) return note(label);
    {
        const Scope scope(label);
        draw();
        closeOnEscape();
    }
    ImGui::EndMenu();
}

void tab(const char* label, const std::function<void()>& draw) {
    const bool wanted = wantedTab == label;
    if (wanted) wantedTab.clear();
    const bool open = ImGui::BeginTabItem(label, nullptr, wanted ? ImGuiTabItemFlags_SetSelected : 0);
    note(label);
    if (!open) return;
    drawnTab = label;
    {
        const Scope scope(label);
        ImGui::BeginChild(label, {0.0f, 0.0f}, false, ImGuiWindowFlags_NoNavInputs);
        draw();
        ImGui::EndChild();
    }
    ImGui::EndTabItem();
}

std::string toText(const std::vector<Item>& items) {
    std::string lines;
    for (const Item& item : items) {
        if (!item.visible) continue;
        std::string path = item.path;
        std::replace(path.begin(), path.end(), '\n', ' ');
        lines += fmt::format("{:.0f}\t{:.0f}\t{:.0f}\t{:.0f}\t{}\n", item.lower.x, item.lower.y,
                             item.upper.x - item.lower.x, item.upper.y - item.lower.y, path);
    }
    return lines;
}

void writeItemMap() {
    static const char* const path = std::getenv("RAYSCOPE_UI_MAP");
    if (path == nullptr) return;
    static std::string written;
    recording = true;
    if (std::string map = toText(recorded); map != written) {
        base::writeFileAtomically(path, map);
        written = std::move(map);
    }
}

}  // namespace rayscope::viewer::ui
