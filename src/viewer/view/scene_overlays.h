#pragma once
#include "viewer/overlay/boxes.h"
#include "viewer/view/drawing_budget.h"
#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {

/// Collects the overlays of rays, traversals, surfaces, BVH and lab.
class SceneOverlays {
  public:
    /// What the overlays depend on besides the camera, the lights and the size of the scene.
    struct Inputs {
        int raysVersion = 0, bvhVersion = 0;
        DebugRayFilter rays;
        TraversalOverlayOptions traversal;
        SurfaceOverlayOptions surface;
        BvhOverlayOptions bvh;
        int labVersion = 0;
        LabMethod labMethod = LabMethod::Float;
        bool lab = false;
        bool operator==(const Inputs&) const = default;
    };
    static Inputs inputsOf(const Workspace& workspace);

    /// The overlays of a frame.
    struct Drawing {
        OverlayBoxes boxes;
        OverlayLines lines, boldLines;  ///< drawn in this order after the boxes
        bool painted = false;           ///< `boxes` and `lines` are many: use paintBoxes() and paintLines()
        DrawnCounts counts;             ///< of boxes and lines
    };
    /// `sceneSize` is the diagonal of the scene.
    Drawing draw(const Workspace& workspace, const ViewFrame& frame, float sceneSize,
                 const DrawingBudget& budget);

  private:
    void addSurfaces(const DebugRays::PixelRecording& recording, const DebugRays& rays, float sceneSize);
    void addRays(const DebugRays::PixelRecording& recording, const DebugRays& rays, float sceneSize);
    void rebuild(const Workspace& workspace, float sceneSize);

    Inputs built_;
    float builtSize_ = -1.0f;
    OverlayLines lines_;
    OverlayBoxes boxes_;
};

}  // namespace rayscope::viewer
