#include <fmt/format.h>
#include <rayscope/display.h>

#include "viewer/overlay/overlay.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

void drawColorBar(const Workspace& workspace, glm::vec2 origin, glm::vec2 size) {
    const HeatMap& heat = workspace.heat;
    if (!workspace.view.traced || heat.image() == nullptr) return;
    const std::string title = fmt::format("{}  {:.4g} to {:.4g}", infoOf(heat.aov).name, heat.from, heat.to);
    const float line = ImGui::GetFontSize(), pad = scaled(6.0f), bar = scaled(10.0f);
    const float width = std::max(ImGui::CalcTextSize(title.c_str()).x, scaled(200.0f));
    const ImVec2 lower{origin.x + size.x - width - 3.0f * pad, origin.y + size.y - bar - line - 4.0f * pad};
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddRectFilled(lower, {lower.x + width + 2.0f * pad, lower.y + bar + line + 3.0f * pad},
                       IM_COL32(15, 17, 20, 200), scaled(3.0f));
    draw.AddText({lower.x + pad, lower.y + pad}, IM_COL32(235, 237, 240, 255), title.c_str());
    constexpr int kSteps = 64;
    const float top = lower.y + line + 2.0f * pad, step = width / static_cast<float>(kSteps);
    for (int i = 0; i < kSteps; ++i) {
        const float x = lower.x + pad + step * static_cast<float>(i);
        const ImU32 color = toU32(toDisplay(mapColor(heat.map, (i + 0.5) / kSteps)));
        draw.AddRectFilled({x, top}, {x + step, top + bar}, color);
    }
    ui::noteArea("Colour bar", {lower.x + pad, top}, {lower.x + pad + width, top + bar});
}

}  // namespace rayscope::viewer
