#pragma once
// Small pieces that all panels are put together from.
#include <imgui.h>
#include <rayscope/vector.h>
#include <string>
#include <string_view>

namespace rayscope::viewer {

/// `units` at scale 1 in pixels of this window; a line of text is 13 units high.
inline float scaled(float units) { return units * ImGui::GetFontSize() / 13.0f; }

inline void text(std::string_view words) {
    ImGui::TextUnformatted(words.data(), words.data() + words.size());
}
void dimText(std::string_view words);
void coloredText(const ImVec4& color, std::string_view words);
void wrappedText(std::string_view words);

/// Starts a row: the label, which explains itself with `help`, on the left; what is drawn next fills the
/// right part. Returns whether the label was double-clicked.
bool labelledRow(std::string_view label, bool emphasised = false, std::string_view help = {});

/// A row of words: in the right part, or, where they are too long for it, as far to the left as it takes.
void valueRow(std::string_view label, std::string_view words, std::string_view help = {});

/// Words in a box of readable width beside what the cursor is on, also if that is disabled.
void tooltip(std::string_view words);

bool colorRow(const char* label, Rgb& color);
bool vectorRow(const char* label, glm::vec3& value, float speed);

/// Words on a dark ground over the picture, to the right or to the left of a place.
void pictureLabel(const char* words, ImVec2 place, bool leftOf = false);

/// How far something is (0 … 1) that takes long, and a button to stop it. Returns whether it was pressed.
bool stoppableProgress(double fraction);

/// A button that looks pressed when it stands for the current choice.
bool toggleButton(const char* label, bool chosen, float width);

}  // namespace rayscope::viewer
