// What acts on one pixel of the picture: the menu of the right button, and the wait for a click on a pixel.
#include <fmt/format.h>

#include <utility>

#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

constexpr const char* kMenuTitle = "Pixel menu";

std::string titleOf(const CursorInfo& cursor) {
    const std::string pixel = fmt::format("Pixel {}, {}", cursor.pixel.x, cursor.pixel.y);
    return cursor.object.empty() ? pixel : pixel + ": " + cursor.object;
}

}  // namespace

void drawContextMenu(Workspace& workspace) {
    if (std::exchange(workspace.openPixelMenu, false)) ImGui::OpenPopup(kMenuTitle);
    if (!workspace.menuPixel || !ImGui::BeginPopup(kMenuTitle)) return;
    const ui::Scope scope(kMenuTitle);
    dimText(titleOf(*workspace.menuPixel));
    for (const CommandInfo& info : commandTable()) {
        if (!info.needsPixel) continue;
        const bool enabled = !info.enabled || info.enabled(workspace);
        if (ui::menuItem(info.label, shortcutText(info).c_str(), false, enabled)) {
            workspace.picked = workspace.menuPixel;
            workspace.commands.push_back(info.command);
        }
        tooltip(info.help);
    }
    ui::closeOnEscape();
    ImGui::EndPopup();
}

void drawPickingMarks(const Workspace& workspace, glm::vec2 origin, glm::vec2 size) {
    if (!workspace.view.picking) return;
    const std::string label =
        fmt::format("{}: click a pixel (Esc cancels)", infoOf(*workspace.view.picking).label);
    const float width = ImGui::CalcTextSize(label.c_str()).x;
    pictureLabel(label.c_str(), {origin.x + 0.5f * (size.x - width), origin.y + scaled(8.0f)});
    if (!workspace.cursor) return;
    const ImVec2 at = ImGui::GetIO().MousePos;
    const float gap = scaled(5.0f);
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const auto line = [&](ImVec2 from, ImVec2 to) {
        draw.AddLine(from, to, IM_COL32(0, 0, 0, 160), scaled(3.0f));
        draw.AddLine(from, to, IM_COL32(255, 255, 255, 230), scaled(1.0f));
    };
    line({origin.x, at.y}, {at.x - gap, at.y});
    line({at.x + gap, at.y}, {origin.x + size.x, at.y});
    line({at.x, origin.y}, {at.x, at.y - gap});
    line({at.x, at.y + gap}, {at.x, origin.y + size.y});
}

}  // namespace rayscope::viewer
