#pragma once
// The controls of Dear ImGui, which report under which label they were drawn and where. Tests find controls
// by label instead of by coordinates. Without a map being recorded, each wrapper is one call and one branch.
#include <imgui.h>

#include <algorithm>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope::viewer::ui {

/// A control or a text of the current frame.
struct Item {
    /// "Tab/Section/Label". The label of a control of a labelled row is that of the row, followed by the
    /// identifier of the control: "Settings/Sampling/Samples per pixel##value".
    std::string path;
    ImVec2 lower, upper;  ///< rectangle in units of the window, clipped to what is visible of it
    bool isText = false;  ///< a text rather than a control; `path` ends with the text itself
    bool enabled = true;
    bool visible = true;
};

/// Records items from the next frame on, or stops recording.
void recordItems(bool on);
/// Starts an empty list for this frame.
void beginFrame();
/// The items of this frame so far.
const std::vector<Item>& items();
/// The visible items, one line each: x, y, width, height and path, separated by tabs.
std::string toText(const std::vector<Item>& items);
/// Writes toText(items()) to the file that the environment variable RAYSCOPE_UI_MAP names, if it has changed
/// since it was written last. Recording starts with the first call if the variable is set.
void writeItemMap();

/// Reports the last item of Dear ImGui under a label.
void note(const char* label, bool isText = false, bool enabled = true);
void noteText(std::string_view text);
/// Reports a rectangle that no item of Dear ImGui covers.
void noteArea(const char* label, ImVec2 lower, ImVec2 upper);
/// The label of the row that the following unlabelled controls ("##value") belong to.
void noteRow(std::string_view label);

/// Items until the end of the scope are listed below its name.
class Scope {
  public:
    explicit Scope(std::string_view name);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
};

inline bool noted(const char* label, bool result) {
    note(label);
    return result;
}

inline bool button(const char* label, ImVec2 size = {0.0f, 0.0f}) {
    return noted(label, ImGui::Button(label, size));
}
inline bool smallButton(const char* label) { return noted(label, ImGui::SmallButton(label)); }
inline bool checkbox(const char* label, bool* value) { return noted(label, ImGui::Checkbox(label, value)); }
inline bool selectable(const char* label, bool selected = false, ImGuiSelectableFlags flags = 0) {
    return noted(label, ImGui::Selectable(label, selected, flags));
}
inline bool menuItem(const char* label, const char* shortcut = nullptr, bool ticked = false,
                     bool enabled = true) {
    const bool pressed = ImGui::MenuItem(label, shortcut, ticked, enabled);
    note(label, false, enabled);
    return pressed;
}
inline bool menuItem(const char* label, const char* shortcut, bool* ticked) {
    return noted(label, ImGui::MenuItem(label, shortcut, ticked));
}
inline bool sliderInt(const char* label, int* value, int lowest, int highest, const char* format = "%d",
                      ImGuiSliderFlags flags = 0) {
    return noted(label, ImGui::SliderInt(label, value, lowest, highest, format, flags));
}
/// Draws a control of these numbers. An edit that makes one of them infinite or NaN, such as 1e999, changes
/// nothing, like a text that is no number. Returns whether they were edited.
bool finiteEdit(std::span<float> values, const std::function<bool()>& draw);

/// What is typed into a control with ImGuiSliderFlags_AlwaysClamp is limited to its range, if it is finite.
inline bool clamped(bool edited, float* value, float lowest, float highest, ImGuiSliderFlags flags) {
    if (edited && (flags & ImGuiSliderFlags_AlwaysClamp) != 0) *value = std::clamp(*value, lowest, highest);
    return edited;
}
inline bool sliderFloat(const char* label, float* value, float lowest, float highest,
                        const char* format = "%.3f", ImGuiSliderFlags flags = 0) {
    const auto draw = [&] {
        return ImGui::SliderFloat(label, value, lowest, highest, format,
                                  flags & ~ImGuiSliderFlags_AlwaysClamp);
    };
    return noted(label, clamped(finiteEdit({value, 1}, draw), value, lowest, highest, flags));
}
inline bool dragFloat(const char* label, float* value, float speed, float lowest, float highest,
                      const char* format, ImGuiSliderFlags flags = 0) {
    const auto draw = [&] {
        return ImGui::DragFloat(label, value, speed, lowest, highest, format,
                                flags & ~ImGuiSliderFlags_AlwaysClamp);
    };
    return noted(label, clamped(finiteEdit({value, 1}, draw), value, lowest, highest, flags));
}
/// An area that draws nothing itself, for instance for a plot.
inline bool area(const char* label, ImVec2 size) { return noted(label, ImGui::InvisibleButton(label, size)); }
/// Which sections are open or closed in contrast to their default, by "Tab/Section". They may be replaced.
std::map<std::string, bool>& sections();
/// The tab that was drawn last, and the one that shall be opened in the next frame.
const std::string& currentTab();
void selectTab(std::string_view name);

/// A header that folds what follows up to the next one.
bool section(const char* label, ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_DefaultOpen);
bool treeNode(const char* label);

/// Closes the menu, list or popup that is being drawn if Esc was pressed in this frame.
void closeOnEscape();

/// A list of choices that opens on a click; `draw` draws its rows with selectable().
void combo(const char* label, const char* shown, const std::function<void()>& draw,
           ImGuiComboFlags flags = 0);
void menu(const char* label, const std::function<void()>& draw, bool enabled = true);
void tab(const char* label, const std::function<void()>& draw);

}  // namespace rayscope::viewer::ui
