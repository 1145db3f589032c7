#pragma once
// Functions of commands that need neither the window nor the picture.
#include "viewer/workspace/workspace.h"

namespace rayscope::viewer {

inline void toggle(bool& value) { value = !value; }

void toggleHeatMap(Workspace& workspace);
void toggleComparison(Workspace& workspace);
inline void keepPicture(Workspace& workspace) { workspace.keepPicture(); }
void flipPictures(Workspace& workspace);
void resetCamera(Workspace& workspace);
/// The camera looks at the surface under the cursor, and orbits around it.
void centerOnPixel(Workspace& workspace);
/// The lens focuses on the surface under the cursor.
void focusOnPixel(Workspace& workspace);
void selectLeafUnderCursor(Workspace& workspace);
/// The first that applies: cancel loading, end waiting for a click on a pixel, close a window, leave fly
/// mode, end the live ray, clear the rays.
void cancel(Workspace& workspace);

}  // namespace rayscope::viewer
