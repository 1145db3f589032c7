#include "viewer/picture.h"

#include "viewer/overlay/light_overlay.h"

namespace rayscope::viewer {

namespace {
/// Time per frame for taking tiles: of 33 ms, what is left beside drawing on a slow machine.
constexpr double kCollectSeconds = 0.006;
/// How strongly lines show that lie behind surfaces.
constexpr float kHiddenOpacity = 0.28f;
}  // namespace

HandleSize handleSize(float scale) {
    return {70.0 * static_cast<double>(scale), 8.0 * static_cast<double>(scale)};
}

Picture::Inputs Picture::inputsOf(const Workspace& workspace, std::optional<Grip> hovered) const {
    const ViewState& view = workspace.view;
    return {workspace.edit,
            view.raster,
            view.traced,
            view.overlay,
            workspace.viewSize,
            SceneOverlays::inputsOf(workspace),
            workspace.heat.version(),
            workspace.heat.image() != nullptr,
            false,
            workspace.comparison.view,
            view.selectedLight,
            view.selectedHandle,
            hovered,
            view.scale};
}

void Picture::update(Workspace& workspace, std::optional<Grip> hovered, bool moving) {
    if (loaded_ != workspace.edit.scene) {
        loaded_ = workspace.edit.scene;
        raster_.setScene(loaded_);
    }
    Inputs inputs = inputsOf(workspace, hovered);
    inputs.moving = moving;
    const bool everything = target_.resize(workspace.viewSize.x, workspace.viewSize.y) || inputs != drawn_;
    std::optional<PixelBounds> changed;
    if (workspace.view.traced)
        changed = traced_.update(workspace.render.session(), workspace.edit.settings, kCollectSeconds);
    if (!everything && !changed) return;

    // While the picture refines, only the part is drawn again that new tiles lie in.
    const RgbImage& image = traced_.image();
    const bool part = !everything && !workspace.comparison.visible() &&
                      glm::ivec2(image.width, image.height) == inputs.size;
    if (part) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(changed->x0, inputs.size.y - changed->y1, changed->x1 - changed->x0,
                  changed->y1 - changed->y0);
    }
    redraw(workspace, inputs);
    glDisable(GL_SCISSOR_TEST);
    drawn_ = std::move(inputs);
}

void Picture::redraw(const Workspace& workspace, const Inputs& inputs) {
    const ViewFrame frame = viewFrame(inputs.state.camera, inputs.size.x, inputs.size.y);
    target_.bind();
    if (inputs.traced && inputs.heatShown)
        traced_.drawInstead(*workspace.heat.image(), inputs.heatVersion, inputs.size);
    else if (inputs.traced && workspace.comparison.visible())
        traced_.drawComparison(workspace.comparison, inputs.state.settings, inputs.size);
    else if (inputs.traced)
        traced_.draw(inputs.state.settings, inputs.size);
    else
        raster_.draw(frame, inputs.raster);
    if (inputs.overlay) drawOverlays(workspace, inputs, frame);
    RenderTarget::unbind();
}

void Picture::drawOverlays(const Workspace& workspace, const Inputs& inputs, const ViewFrame& frame) {
    const std::vector<Light>& lights = inputs.state.scene->lights;
    const float size = glm::distance(raster_.bounds().lower, raster_.bounds().upper);
    const glm::mat4 toClip = viewProjection(frame, raster_.bounds());
    const glm::vec2 viewport(inputs.size);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    sceneLines_.upload(overlays_.lines(workspace, frame, size, inputs.moving));
    if (inputs.traced) {
        glDisable(GL_DEPTH_TEST);
        sceneLines_.draw(toClip, viewport, inputs.scale, 1.0f);
    } else {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        sceneLines_.draw(toClip, viewport, inputs.scale, kHiddenOpacity);
        glDepthFunc(GL_LEQUAL);
        sceneLines_.draw(toClip, viewport, inputs.scale, 1.0f);
        glDepthFunc(GL_LESS);
        glDisable(GL_DEPTH_TEST);
    }
    if (inputs.selectedLight >= 0) {
        const Light& light = lights[static_cast<std::size_t>(inputs.selectedLight)];
        const glm::dvec3 center(handlesOf(light)[static_cast<std::size_t>(inputs.selectedHandle)]);
        handleLines_.upload(handleLines(frame, center, inputs.hovered, handleSize(inputs.scale)));
        handleLines_.draw(toClip, viewport, inputs.scale, 1.0f);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

RgbImage Picture::rasterImage(const Workspace& workspace) {
    Inputs bare = inputsOf(workspace, std::nullopt);
    bare.overlay = bare.traced = false;
    redraw(workspace, bare);
    drawn_ = {};  // the next update() draws the overlays again
    target_.bind();
    RgbImage image = readFramebuffer(0, 0, bare.size.x, bare.size.y);
    RenderTarget::unbind();
    return image;
}

}  // namespace rayscope::viewer
