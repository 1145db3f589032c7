#include <fmt/format.h>

#include <numbers>

#include "math/vectors.h"
#include "viewer/model/light_handles.h"
#include "viewer/panels/panels.h"
#include "viewer/panels/widgets.h"

namespace rayscope::viewer {

namespace {

const char* kindOf(const Light& light) {
    constexpr const char* kNames[] = {"Point", "Segment", "Parallelogram"};
    return kNames[light.shape.index()];
}

bool drawShape(PointLight& light, float speed) {
    bool edited = vectorRow("Position", light.position, speed);
    edited |= colorRow("Colour", light.color);
    return edited;
}

bool drawShape(SegmentLight& light, float speed) {
    bool edited = false;
    for (std::size_t i = 0; i < 2; ++i) {
        edited |= vectorRow(i == 0 ? "End 0" : "End 1", light.endpoints[i], speed);
        edited |= colorRow(i == 0 ? "Colour 0" : "Colour 1", light.colors[i]);
    }
    return edited;
}

bool drawShape(ParallelogramLight& light, float speed) {
    constexpr const char* kColors[] = {"Colour at corner", "Colour at edge 0", "Colour at edge 1",
                                       "Colour opposite"};
    bool edited = vectorRow("Corner", light.corner, speed);
    edited |= vectorRow("Edge 0", light.edges[0], speed);
    edited |= vectorRow("Edge 1", light.edges[1], speed);
    for (std::size_t i = 0; i < 4; ++i) edited |= colorRow(kColors[i], light.colors[i]);
    return edited;
}

/// A new light just below the top of the scene bounds, above their centre, sized relative to the scene.
Light newLight(int kind, const SceneBounds& bounds) {
    const glm::vec3 center = (bounds.lower + bounds.upper) * 0.5f, size = bounds.upper - bounds.lower;
    const glm::vec3 position(center.x, bounds.upper.y - 0.1f * size.y, center.z);
    const auto half = static_cast<float>(0.15 * math::length(size) / std::numbers::sqrt3);
    if (kind == 0) return {PointLight{position, Rgb(1.0f)}};
    if (kind == 1)
        return {SegmentLight{{position - glm::vec3(half, 0, 0), position + glm::vec3(half, 0, 0)},
                             {Rgb(1.0f, 0.5f, 0.4f), Rgb(0.4f, 0.5f, 1.0f)}}};
    return {ParallelogramLight{position - glm::vec3(half, 0, half),
                               {glm::vec3(2 * half, 0, 0), glm::vec3(0, 0, 2 * half)},
                               {Rgb(1.0f), Rgb(1.0f), Rgb(1.0f), Rgb(1.0f)}}};
}

void drawAddButtons(Workspace& workspace) {
    constexpr const char* kLabels[] = {"+ Point", "+ Segment", "+ Parallelogram"};
    constexpr float kWidthFractions[] = {0.24f, 0.31f, 0.45f};
    const float width = ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x;
    for (int kind = 0; kind < 3; ++kind) {
        if (kind > 0) ImGui::SameLine();
        if (!ui::button(kLabels[kind], {kWidthFractions[kind] * width, 0.0f})) continue;
        std::vector<Light> lights = workspace.edit.scene->lights;
        lights.push_back(newLight(kind, workspace.edit.bounds));
        workspace.view.selectedLight = static_cast<int>(lights.size()) - 1;
        workspace.view.selectedHandle = 0;
        workspace.setLights(std::move(lights));
    }
}

void drawList(Workspace& workspace) {
    const std::vector<Light>& lights = workspace.edit.scene->lights;
    for (int i = 0; i < static_cast<int>(lights.size()); ++i) {
        const bool selected = i == workspace.view.selectedLight;
        const std::string label = fmt::format("Light {}: {}", i, kindOf(lights[static_cast<std::size_t>(i)]));
        if (!ui::selectable(label.c_str(), selected)) continue;
        workspace.view.selectedLight = selected ? -1 : i;
        workspace.view.selectedHandle = 0;
    }
    if (lights.empty()) wrappedText("No lights: surfaces are black unless shading is off.");
}

void drawSelected(Workspace& workspace) {
    const auto index = static_cast<std::size_t>(workspace.view.selectedLight);
    std::vector<Light> lights = workspace.edit.scene->lights;
    Light& light = lights[index];
    const SceneBounds& bounds = workspace.edit.bounds;
    const auto speed = static_cast<float>(0.002 * math::distance(bounds.lower, bounds.upper));

    labelledRow("Handle");
    ui::combo("##handle", handleName(light, workspace.view.selectedHandle), [&] {
        for (int handle = 0; handle < static_cast<int>(handlePositions(light).size()); ++handle)
            if (ui::selectable(handleName(light, handle), handle == workspace.view.selectedHandle))
                workspace.view.selectedHandle = handle;
    });
    tooltip("The point that the arrows in the picture move. A click on a light selects one, too.");
    bool edited = std::visit([&](auto& shape) { return drawShape(shape, speed); }, light.shape);
    bool inverseSquare = light.falloff == Falloff::InverseSquare;
    labelledRow("Inverse-square");
    if (ui::checkbox("##falloff", &inverseSquare)) {
        light.falloff = inverseSquare ? Falloff::InverseSquare : Falloff::None;
        edited = true;
    }
    tooltip("The light falls off with the square of the distance.");
    if (ui::button("Remove", {-1.0f, 0.0f})) {
        lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(index));
        edited = true;
        workspace.view.selectedLight = -1;
    }
    if (edited) workspace.setLights(std::move(lights));
}

}  // namespace

void drawLightsPanel(Workspace& workspace) {
    drawList(workspace);
    if (workspace.view.selectedLight >= 0) {
        ImGui::Separator();
        drawSelected(workspace);
        ImGui::Separator();
    }
    drawAddButtons(workspace);
    ImGui::Spacing();
}

}  // namespace rayscope::viewer
