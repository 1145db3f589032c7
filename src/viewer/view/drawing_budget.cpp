#include "viewer/view/drawing_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rayscope::viewer {

bool isSoftwareRenderer(std::string_view name) {
    // Those of Mesa, Windows and Google.
    constexpr std::array kNames{"llvmpipe", "softpipe", "SWR", "GDI Generic", "SwiftShader"};
    return std::any_of(kNames.begin(), kNames.end(),
                       [&](const char* known) { return name.find(known) != std::string_view::npos; });
}

DrawingBudget drawingBudget(bool software, bool moving) {
    DrawingBudget budget;
    if (!software || !moving) return budget;
    // With Mesa's llvmpipe on two cores each of these takes at most about 8 of the 33 ms of a frame. Without
    // the limit on triangles a mesh of a million takes 170 ms.
    budget.triangles = 8000;
    budget.boxes = 10000;
    budget.linePixels = 6e6;
    budget.maxWideLines = 100;
    budget.divisor = 2;
    return budget;
}

std::string drawnText(const DrawnCounts& counts) {
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (counts.linesDrawn < counts.lines) add(fmt::format("{} of {} lines", counts.linesDrawn, counts.lines));
    if (counts.boxesDrawn < counts.boxes)
        add(fmt::format("{} of {} boxes whole", counts.boxesDrawn, counts.boxes));
    if (counts.trianglesDrawn < counts.triangles)
        add(fmt::format("{} triangles for {}", counts.trianglesDrawn, counts.triangles));
    if (counts.divisor > 1) add(fmt::format("1/{} of the resolution", counts.divisor));
    return text;
}

}  // namespace rayscope::viewer
