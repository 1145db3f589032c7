#pragma once
#include <imgui.h>

namespace rayscope::viewer {

/// Dark colours, and a font and spacings for `scale` pixels per unit. Needs no rendering context.
void applyTheme(float scale);

/// Pixels of the window per unit, as the theme was applied.
float themeScale();

/// Text colours with a meaning.
inline const ImVec4 kDimText{0.58f, 0.61f, 0.66f, 1.0f};
inline const ImVec4 kWarningText{0.95f, 0.75f, 0.35f, 1.0f};
inline const ImVec4 kErrorText{0.96f, 0.47f, 0.42f, 1.0f};
inline const ImVec4 kGoodText{0.48f, 0.80f, 0.56f, 1.0f};

}  // namespace rayscope::viewer
