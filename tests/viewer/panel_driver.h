#pragma once
// Drives the panels of the window without a window: Dear ImGui without a back end, a mouse and a keyboard
// that the test moves, and controls that are found by label.
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

struct ImGuiContext;

namespace rayscope::viewer {

class PanelDriver {
  public:
    /// Opens a built-in scene; its picture has 64 x 48 pixels.
    explicit PanelDriver(const std::string& scene, const std::map<std::string, std::string>& settings = {});
    ~PanelDriver();
    PanelDriver(const PanelDriver&) = delete;
    PanelDriver& operator=(const PanelDriver&) = delete;

    Workspace workspace;
    OpenDialog openDialog;
    RenderWindow renderWindow;
    /// The commands that controls have issued since the last call.
    std::vector<Command> takeCommands();

    /// Draws the menu, the side panel and all dialogs, and lets background work report.
    void frame();
    /// Frames until the condition holds; a failure of the test after 60 s.
    void waitFor(const char* what, const std::function<bool()>& condition);
    /// Frames until the world of the current state is compiled.
    void waitForWorld();
    /// Records the rays of a pixel of the current picture, as the key R does, and waits for its diagnosis,
    /// whose text moves the controls below it.
    void recordPixel(int x, int y);

    /// Labels are paths "Tab/Section/Label", without leading parts where the rest is unique; see items.h.
    bool has(std::string_view label) const;
    bool isEnabled(std::string_view label) const;
    /// Whether a text of this frame contains this one.
    bool shows(std::string_view part) const;
    void hover(std::string_view label);
    void click(std::string_view label);
    /// Two clicks in quick succession.
    void doubleClick(std::string_view label);
    /// Clicks beside all panels, which closes menus.
    void clickPicture() { press({400.0f, 400.0f}); }
    /// Double-clicks the text of a row, which resets its value.
    void doubleClickLabel(std::string_view label);
    /// Types a number into a slider or a field to drag.
    void type(std::string_view label, const std::string& text);
    /// Replaces the text of an input field.
    void replaceText(std::string_view label, const std::string& text);
    /// Opens the combo of a row and clicks one of its choices.
    void choose(const std::string& row, const std::string& choice);
    void pressEnter() { pressKey(ImGuiKey_Enter); }
    void pressKey(ImGuiKey key);
    /// The rectangle of a control or a text.
    ui::Item at(std::string_view label) { return get(label); }
    /// Drags within a control, by fractions of its width.
    void drag(std::string_view label, float from, float to);

  private:
    enum class Kind { Any, Text };
    const ui::Item* find(std::string_view label, Kind kind = Kind::Any) const;
    const ui::Item& get(std::string_view label);
    void press(ImVec2 position);
    void pressTwice(ImVec2 position);

    ImGuiContext* context_;
};

/// Clicks a toggle twice and expects it to switch and to switch back.
void expectToggle(PanelDriver& driver, const std::string& label, const bool& value);

}  // namespace rayscope::viewer
