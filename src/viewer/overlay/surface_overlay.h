#pragma once
#include "probe/surface_report.h"
#include "viewer/overlay/overlay.h"

namespace rayscope::viewer {

/// The edges of the triangle and the normals of its vertices, `length` long.
OverlayLines vertexNormalLines(const probe::VertexNormals& normals, float length);

/// The square as two triangles, and the mirror direction through its centre.
OverlayLines glossySquareLines(const probe::GlossySquare& square);

/// A ray of this length into the environment, in the colour that is looked up.
OverlayLines environmentLines(const probe::EnvironmentPoint& point, glm::vec3 from, float length);

/// The outline of the aperture; the plane of focus, and dashed the planes of the sharp zone.
OverlayLines lensLines(const probe::LensReport& lens);

}  // namespace rayscope::viewer
