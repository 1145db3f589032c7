#include "viewer/view/picture.h"

#include "math/vectors.h"
#include "viewer/overlay/light_overlay.h"

namespace rayscope::viewer {

namespace {
/// Opacity of lines behind surfaces.
constexpr float kHiddenOpacity = 0.28f;

std::string_view rendererName() {
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return name ? name : "";
}
}  // namespace

Picture::Picture()
    : software_(isSoftwareRenderer(rendererName())), raster_(drawingBudget(software_, true).triangles) {}

Picture::Inputs Picture::inputsOf(const Workspace& workspace, std::optional<HandlePart> hovered) const {
    const ViewState& view = workspace.view;
    return {
        workspace.edit,
        {workspace.edit.settings.normalInterpolation, workspace.edit.settings.textureMapping, view.wireframe},
        view.traced,
        view.overlay,
        workspace.viewSize,
        SceneOverlays::inputsOf(workspace),
        workspace.heat.version(),
        workspace.heat.image() != nullptr && workspace.heat.isOf(workspace.render.currentWorld()),
        false,
        workspace.comparison.view,
        view.selectedLight,
        view.selectedHandle,
        hovered,
        view.scale};
}

void Picture::update(Workspace& workspace, std::optional<HandlePart> hovered, bool moving) {
    if (loaded_ != workspace.edit.scene) {
        loaded_ = workspace.edit.scene;
        raster_.setScene(loaded_, workspace.edit.bounds);
    }
    Inputs inputs = inputsOf(workspace, hovered);
    inputs.moving = moving;
    const bool everything = resize(inputs) || inputs != drawn_;
    std::optional<PixelBounds> changed;
    if (workspace.view.traced) changed = traced_.update(workspace.shown);
    if (!everything && !changed) return;

    // While the picture is refined, only the rectangle of the new tiles is drawn again.
    const RgbImage& image = workspace.shown.image();
    const glm::ivec2 pixels(target_.width(), target_.height());
    const bool part =
        !everything && !workspace.comparison.visible() && glm::ivec2(image.width, image.height) == pixels;
    if (part) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(changed->x0, pixels.y - changed->y1, changed->x1 - changed->x0, changed->y1 - changed->y0);
    }
    redraw(workspace, inputs);
    glDisable(GL_SCISSOR_TEST);
    drawn_ = std::move(inputs);
}

/// The target has the resolution of the view, or less while something moves.
bool Picture::resize(const Inputs& inputs) {
    const int divisor = drawingBudget(software_, inputs.moving).divisor;
    return target_.resize((inputs.size.x + divisor - 1) / divisor, (inputs.size.y + divisor - 1) / divisor);
}

void Picture::redraw(const Workspace& workspace, const Inputs& inputs) {
    const ViewFrame frame = viewFrame(inputs.state.camera, inputs.size.x, inputs.size.y);
    const glm::ivec2 pixels(target_.width(), target_.height());
    target_.bind();
    counts_ = {};
    if (inputs.traced && inputs.heatShown)
        traced_.drawImage(*workspace.heat.image(), inputs.heatVersion, pixels);
    else if (inputs.traced && workspace.comparison.visible())
        traced_.drawComparison(workspace.comparison, inputs.state.settings, pixels);
    else if (inputs.traced)
        traced_.draw(inputs.state.settings, pixels);
    else
        counts_ = raster_.draw(target_, frame, inputs.raster, inputs.moving);
    counts_.divisor = drawingBudget(software_, inputs.moving).divisor;
    if (inputs.overlay) drawOverlays(workspace, inputs, frame);
    RenderTarget::unbind();
}

void Picture::drawOverlays(const Workspace& workspace, const Inputs& inputs, const ViewFrame& frame) {
    const auto size = static_cast<float>(math::distance(raster_.bounds().lower, raster_.bounds().upper));
    SceneOverlays::Drawing drawing =
        overlays_.draw(workspace, frame, size, drawingBudget(software_, inputs.moving));
    counts_.boxes = drawing.counts.boxes;
    counts_.boxesDrawn = drawing.counts.boxesDrawn;
    counts_.lines = drawing.counts.lines;
    counts_.linesDrawn = drawing.counts.linesDrawn;

    LineDrawOptions look{viewProjection(frame, raster_.bounds()), glm::vec2(inputs.size), inputs.scale};
    if (!inputs.traced) {
        look.sceneDepth = target_.depthTexture();
        look.hiddenOpacity = kHiddenOpacity;
    }
    if (drawing.painted) paintLines(drawing, look);
    target_.bindColorOnly();
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    if (!drawing.painted) drawLines(drawing, look);
    boldLines_.upload(drawing.boldLines);
    boldLines_.draw(look);
    drawHandles(inputs, frame, look);
    glDisable(GL_BLEND);
}

void Picture::drawLines(SceneOverlays::Drawing& drawing, const LineDrawOptions& look) {
    OverlayLines lines;
    lines.reserve(12 * drawing.boxes.size() + drawing.lines.size());
    for (const OverlayBox& box : drawing.boxes)
        appendBox(lines, box.lower, box.upper, box.color, box.style, box.width);
    lines.insert(lines.end(), drawing.lines.begin(), drawing.lines.end());
    sceneLines_.upload(lines);
    sceneLines_.draw(look);
}

void Picture::paintLines(const SceneOverlays::Drawing& drawing, const LineDrawOptions& look) {
    canvas_.width = target_.width();
    canvas_.height = target_.height();
    target_.readColors(canvas_.pixels);
    if (look.sceneDepth != 0)
        target_.readDepths(canvas_.depth);
    else
        canvas_.depth.clear();
    const float unit = look.scale * static_cast<float>(canvas_.width) / look.viewport.x;
    const PaintOptions paint{look.viewProjection, unit, look.hiddenOpacity};
    paintBoxes(canvas_, drawing.boxes, paint);
    viewer::paintLines(canvas_, drawing.lines, paint);
    target_.writeColors(canvas_.pixels);
}

/// The handles of the selected light, in front of everything.
void Picture::drawHandles(const Inputs& inputs, const ViewFrame& frame, LineDrawOptions look) {
    if (inputs.selectedLight < 0) return;
    const Light& light = inputs.state.scene->lights[static_cast<std::size_t>(inputs.selectedLight)];
    const glm::dvec3 center(handlePositions(light)[static_cast<std::size_t>(inputs.selectedHandle)]);
    look.sceneDepth = 0;
    boldLines_.upload(handleLines(frame, center, inputs.hovered, handleSize(inputs.scale)));
    boldLines_.draw(look);
}

FramebufferPixels Picture::rasterPixels(const Workspace& workspace) {
    Inputs bare = inputsOf(workspace, std::nullopt);
    bare.overlay = bare.traced = false;
    resize(bare);
    redraw(workspace, bare);
    drawn_ = {};  // the next update() draws the overlays again
    target_.bind();
    FramebufferPixels pixels = readFramebuffer(0, 0, bare.size.x, bare.size.y);
    RenderTarget::unbind();
    return pixels;
}

}  // namespace rayscope::viewer
