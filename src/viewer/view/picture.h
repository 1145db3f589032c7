#pragma once
#include <optional>

#include "viewer/gl/line_batch.h"
#include "viewer/gl/render_target.h"
#include "viewer/model/light_handles.h"
#include "viewer/overlay/line_painter.h"
#include "viewer/view/raster_view.h"
#include "viewer/view/scene_overlays.h"
#include "viewer/view/traced_view.h"
#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {

/// The picture area: one of the two views with its overlays, redrawn only when something changed.
class Picture {
  public:
    Picture();

    /// Updates the off-screen picture. `hovered` is the part of the light's handle to highlight.
    void update(Workspace& workspace, std::optional<HandlePart> hovered, bool moving);

    /// Copies the finished picture to the window, its lower left corner to this pixel.
    void show(glm::ivec2 corner) const {
        target_.copyToWindow(corner.x, corner.y, drawn_.size.x, drawn_.size.y);
    }

    /// The rasterised view without overlays, of the view's size.
    FramebufferPixels rasterPixels(const Workspace& workspace);
    /// How much of the scene and the overlays the picture shows.
    const DrawnCounts& counts() const { return counts_; }

  private:
    /// Everything that the picture depends on besides the traced image.
    struct Inputs {
        EditState state;
        RasterStyle raster;
        bool traced = false, overlay = false;
        glm::ivec2 size{0};
        SceneOverlays::Inputs overlays;
        int heatVersion = 0;
        bool heatShown = false, moving = false;
        Comparison::View comparison;
        int selectedLight = -1, selectedHandle = 0;
        std::optional<HandlePart> hovered;
        float scale = 1.0f;
        bool operator==(const Inputs&) const = default;
    };
    Inputs inputsOf(const Workspace& workspace, std::optional<HandlePart> hovered) const;
    bool resize(const Inputs& inputs);
    void redraw(const Workspace& workspace, const Inputs& inputs);
    void drawLines(SceneOverlays::Drawing& drawing, const LineDrawOptions& look);
    void paintLines(const SceneOverlays::Drawing& drawing, const LineDrawOptions& look);
    void drawOverlays(const Workspace& workspace, const Inputs& inputs, const ViewFrame& frame);
    void drawHandles(const Inputs& inputs, const ViewFrame& frame, LineDrawOptions look);

    bool software_;  ///< OpenGL runs on the CPU
    RenderTarget target_;
    RasterView raster_;
    TracedView traced_;
    SceneOverlays overlays_;
    LineBatch sceneLines_, boldLines_;
    PaintCanvas canvas_;  ///< kept to reuse its memory
    Inputs drawn_;
    DrawnCounts counts_;
    std::shared_ptr<const SceneDescription> loaded_;
};

}  // namespace rayscope::viewer
