#pragma once
#include <chrono>
#include <optional>

#include "viewer/input/window.h"
#include "viewer/model/light_handles.h"
#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {

/// Translates mouse and keyboard input in the picture area into camera and light movements, and determines
/// the pixel and the surface under the cursor.
class ViewInput {
  public:
    /// `origin` is the upper left corner of the picture in the window's units, `unit` the pixels per unit.
    void update(Workspace& workspace, const Window& window, glm::dvec2 origin, double unit, double seconds);

    /// Whether camera or light are in motion: previews are preferred then.
    bool moving() const;
    bool dragging() const { return drag_ != Drag::None; }
    std::optional<HandlePart> hoveredHandlePart() const { return handlePart_; }

  private:
    enum class Drag { None, Orbit, Pan, Look, Handle, Divider };
    using Clock = std::chrono::steady_clock;

    bool onDivider(const Workspace& workspace, const ViewFrame& frame) const;
    void press(Workspace& workspace, const ViewFrame& frame, bool left);
    void dragTo(Workspace& workspace, const ViewFrame& frame);
    void release(Workspace& workspace, const ViewFrame& frame);
    void pickDebugRay(Workspace& workspace, const ViewFrame& frame);
    void wheel(Workspace& workspace, const ViewFrame& frame, double notches);
    bool fly(Workspace& workspace, const Window& window, double seconds);
    void updateCursor(Workspace& workspace, const ViewFrame& frame, bool inside);

    Drag drag_ = Drag::None;
    std::optional<HandlePart> handlePart_;
    glm::dvec2 cursor_{0.0}, pressed_{0.0}, last_{0.0};  ///< pixels of the picture
    bool rightButton_ = false;                           ///< went down last
    bool clicked_ = false;  ///< the button went down and the cursor has hardly moved since
    glm::dvec3 handleStart_{0.0};
    ViewFrame dragFrame_;
    Clock::time_point lastWheel_{}, lastFlight_{};
};

}  // namespace rayscope::viewer
