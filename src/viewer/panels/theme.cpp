#include "viewer/panels/theme.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#ifdef RAYSCOPE_FONT
#include "embedded_font.h"
#endif

namespace rayscope::viewer {

namespace {

ImVec4 grey(float value, float alpha = 1.0f) { return {value * 0.95f, value * 0.98f, value * 1.06f, alpha}; }
ImVec4 accent(float alpha) { return {0.28f, 0.53f, 0.84f, alpha}; }

void setColors(ImVec4* colors) {
    colors[ImGuiCol_Text] = {0.87f, 0.88f, 0.90f, 1.0f};
    colors[ImGuiCol_TextDisabled] = {0.50f, 0.52f, 0.56f, 1.0f};
    colors[ImGuiCol_WindowBg] = grey(0.125f);
    colors[ImGuiCol_ChildBg] = grey(0.0f, 0.0f);
    colors[ImGuiCol_PopupBg] = grey(0.145f, 0.98f);
    colors[ImGuiCol_Border] = grey(0.24f);
    colors[ImGuiCol_FrameBg] = grey(0.205f);
    colors[ImGuiCol_FrameBgHovered] = grey(0.26f);
    colors[ImGuiCol_FrameBgActive] = grey(0.30f);
    colors[ImGuiCol_TitleBg] = grey(0.15f);
    colors[ImGuiCol_TitleBgActive] = grey(0.18f);
    colors[ImGuiCol_MenuBarBg] = grey(0.155f);
    colors[ImGuiCol_ScrollbarBg] = grey(0.11f, 0.6f);
    colors[ImGuiCol_ScrollbarGrab] = grey(0.28f);
    colors[ImGuiCol_ScrollbarGrabHovered] = grey(0.35f);
    colors[ImGuiCol_ScrollbarGrabActive] = grey(0.42f);
    colors[ImGuiCol_CheckMark] = {0.47f, 0.71f, 0.98f, 1.0f};
    colors[ImGuiCol_SliderGrab] = accent(0.85f);
    colors[ImGuiCol_SliderGrabActive] = {0.42f, 0.66f, 0.95f, 1.0f};
    colors[ImGuiCol_Button] = grey(0.23f);
    colors[ImGuiCol_ButtonHovered] = grey(0.30f);
    colors[ImGuiCol_ButtonActive] = accent(0.80f);
    colors[ImGuiCol_Header] = grey(0.185f);
    colors[ImGuiCol_HeaderHovered] = grey(0.25f);
    colors[ImGuiCol_HeaderActive] = grey(0.30f);
    colors[ImGuiCol_Separator] = grey(0.24f);
    colors[ImGuiCol_SeparatorHovered] = accent(0.7f);
    colors[ImGuiCol_SeparatorActive] = accent(1.0f);
    colors[ImGuiCol_Tab] = grey(0.15f);
    colors[ImGuiCol_TabHovered] = grey(0.30f);
    colors[ImGuiCol_TabActive] = grey(0.26f);
    colors[ImGuiCol_TabUnfocused] = grey(0.15f);
    colors[ImGuiCol_TabUnfocusedActive] = grey(0.26f);
    colors[ImGuiCol_NavHighlight] = accent(0.8f);
    colors[ImGuiCol_PlotHistogram] = accent(0.9f);
    colors[ImGuiCol_PlotLines] = accent(1.0f);
    colors[ImGuiCol_TextSelectedBg] = accent(0.45f);
    colors[ImGuiCol_ModalWindowDimBg] = {0.0f, 0.0f, 0.0f, 0.45f};
}

#ifdef RAYSCOPE_FONT

constexpr float kTextUnits = 15.0f;

float sharpScale(float scale) { return scale; }

void loadFont(float scale) {
    // Latin, Greek and Cyrillic letters, punctuation, arrows and mathematical signs.
    static constexpr ImWchar kRanges[] = {0x0020, 0x024f, 0x0370, 0x04ff, 0x2010, 0x2027,
                                          0x2190, 0x21ff, 0x2200, 0x22ff, 0};
    const std::string_view font = fonts::files().front().content;
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;  // the atlas only reads the data
    config.OversampleH = 2;
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.AddFontFromMemoryTTF(const_cast<char*>(font.data()), static_cast<int>(font.size()),
                               std::round(kTextUnits * scale), &config, kRanges);
}

#else

constexpr float kTextUnits = 13.0f;

/// The bitmap font is sharp at whole multiples of its size only.
float sharpScale(float scale) { return std::max(1.0f, std::round(scale)); }

void loadFont(float scale) {
    ImFontConfig config;
    config.OversampleH = config.OversampleV = 1;
    config.PixelSnapH = true;
    config.SizePixels = kTextUnits * scale;
    ImGui::GetIO().Fonts->Clear();
    ImGui::GetIO().Fonts->AddFontDefault(&config);
}

#endif

float appliedScale = 1.0f;

}  // namespace

float themeScale() { return appliedScale; }

void applyTheme(float scale) {
    appliedScale = sharpScale(scale);
    ImGuiStyle style;
    setColors(style.Colors);
    style.WindowPadding = {10, 8};
    style.FramePadding = {6, 3};
    style.ItemSpacing = {8, 5};
    style.ItemInnerSpacing = {6, 4};
    style.IndentSpacing = 14;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 9;
    style.WindowRounding = 4;
    style.FrameRounding = 3;
    style.PopupRounding = 4;
    style.GrabRounding = 3;
    style.ScrollbarRounding = 4;
    style.WindowBorderSize = 1;
    style.PopupBorderSize = 1;
    style.WindowTitleAlign = {0.0f, 0.5f};
    style.DisabledAlpha = 0.45f;
    style.ScaleAllSizes(appliedScale);
    ImGui::GetStyle() = style;
    loadFont(appliedScale);
}

}  // namespace rayscope::viewer
