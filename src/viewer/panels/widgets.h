#pragma once
// Widgets shared by all panels.
#include <imgui.h>
#include <rayscope/vector.h>
#include <string>
#include <string_view>

#include "viewer/panels/items.h"
#include "viewer/panels/theme.h"

namespace rayscope::viewer {

/// `units` at scale 1 in pixels of this window.
inline float scaled(float units) { return units * themeScale(); }

/// Sliders keep typed values within their range.
constexpr ImGuiSliderFlags kClamp = ImGuiSliderFlags_AlwaysClamp;

ImU32 toU32(const glm::vec4& color);
inline ImU32 toU32(const glm::vec3& color) { return toU32(glm::vec4(color, 1.0f)); }

/// The components with four digits each.
std::string vectorText(const glm::dvec3& v);

/// Shows a text, cut after some thousand characters: texts of files may have any length, and Dear ImGui's
/// vertices of one wrapped text have 16-bit indices.
void text(std::string_view content);
void dimText(std::string_view content);
void coloredText(const ImVec4& color, std::string_view content);
void wrappedText(std::string_view content);

/// Starts a row: the label, with `help` as its tooltip, on the left; the next item fills the right part.
/// Returns whether the label was double-clicked.
bool labelledRow(std::string_view label, bool emphasised = false, std::string_view help = {});

/// A text that is cut at the right edge if it is too long for the line; then its tooltip is the whole text.
void fittedText(std::string_view content);

/// A row with a text in the right part; a text that is too long for it starts further left, and is cut if it
/// is too long for the row.
void valueRow(std::string_view label, std::string_view content, std::string_view help = {});

/// Tooltip of the last item, wrapped to a readable width; also for disabled items, whose tooltip is not
/// faded.
void tooltip(std::string_view content);
/// The same at the cursor, whatever is there.
void showTooltip(std::string_view content);

bool colorRow(const char* label, Rgb& color);
bool vectorRow(const char* label, glm::vec3& value, float speed);

/// Whether the key was pressed in this frame; a key that is held down counts once.
bool keyPressed(ImGuiKey key);
/// Whether Enter was pressed in the current window, which it has not opened itself.
bool enterPressed();

/// A text on a dark background over the picture, to the right or to the left of `position`.
void pictureLabel(const char* content, ImVec2 position, bool leftOf = false);

/// Progress (0 … 1) of a measurement and a button that stops it. Returns whether the button was pressed.
bool stoppableProgress(double fraction);

/// A button that looks pressed while its choice is the current one.
bool toggleButton(const char* label, bool chosen, float width);

}  // namespace rayscope::viewer
