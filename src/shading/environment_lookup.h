#pragma once
#include <rayscope/scene.h>

namespace rayscope::shading {

/// Where a direction meets the cube: the face (in the order +x −x +y −y +z −z) and the position on it, both
/// coordinates in [0, 1] with (0, 0) at the upper left corner of the face's image. Faces are oriented as the
/// cube maps of OpenGL (specification 4.6, table 8.19), for which most sky boxes are made.
struct CubePoint {
    int face;
    double s, t;
};
CubePoint cubePoint(const glm::dvec3& direction);

/// The direction of a point of a face, not normalised; coordinates outside [0, 1] lead over the edge.
glm::dvec3 cubeDirection(int face, double s, double t);

/// Radiance from the direction, which need not be of unit length; a zero or non-finite direction reads +z.
/// Both maps are filtered bilinearly without seams: beyond the edge of a face, texels of its neighbour are
/// taken.
glm::dvec3 lookup(const Environment& environment, const glm::dvec3& direction);

}  // namespace rayscope::shading
