#pragma once
// Camera gestures as pure functions on a camera. Angles are in radians, distances in pixels of the picture
// unless stated otherwise.
#include <rayscope/scene.h>

#include "viewer/model/projection.h"

namespace rayscope::viewer {

/// Rotates the camera around its look-at point, as if the scene were dragged. The horizon stays level, and
/// the camera stops just before it looks along its up vector.
void orbit(CameraDescription& camera, glm::dvec2 dragged);

/// Moves camera and look-at point together so that the plane through the look-at point follows the cursor.
void pan(CameraDescription& camera, glm::dvec2 dragged, int pictureHeight);

/// Scales the distance of the camera to `anchor` by `factor`; the anchor stays under the cursor, and the view
/// direction stays. Does nothing if float32 could not resolve the result.
void zoomToward(CameraDescription& camera, glm::dvec3 anchor, double factor);

/// The point under `pixel` at the depth of the look-at point: the anchor of a zoom when nothing is hit.
glm::dvec3 pointAtFocusDepth(const CameraDescription& camera, const ViewFrame& frame, glm::dvec2 pixel);

/// Turns the camera in place, following the mouse.
void look(CameraDescription& camera, glm::dvec2 dragged);

/// Moves the camera by `step` = (right, up, forward), in scene units.
void walk(CameraDescription& camera, glm::dvec3 step);

/// Keeps the direction and sets the distance at which the whole scene is in the picture.
void frameAll(CameraDescription& camera, const SceneBounds& bounds, double aspect);

/// Looks at the same point from the direction of an axis, at the same distance.
void viewAlong(CameraDescription& camera, glm::dvec3 from);

/// A speed that crosses the scene in eight seconds, in scene units per second.
double defaultFlySpeed(const SceneBounds& bounds);

}  // namespace rayscope::viewer
