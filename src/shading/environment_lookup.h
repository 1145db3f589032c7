#pragma once
#include <rayscope/scene.h>

namespace rayscope::shading {

/// Intersection of a direction with the cube: the face, in the order +x −x +y −y +z −z, and the position on
/// it, both coordinates in [0, 1] with (0, 0) at the upper left corner of the face's image. Images are seen
/// from inside the cube: those at the sides with y up, that of +y with +z down, that of −y with +z up. Cube
/// maps of OpenGL and DirectX are seen from outside: the same images, mirrored.
struct CubePoint {
    int face;
    double s, t;
};
CubePoint cubePoint(const glm::dvec3& direction);

/// The direction to a point of a face, not normalised; coordinates outside [0, 1] lie beyond its edges.
glm::dvec3 cubeDirection(int face, double s, double t);

/// Radiance from a direction of any length; a zero or non-finite direction reads +z. Both kinds of map are
/// filtered bilinearly without seams: beyond the edge of a face, texels of the neighbouring face are used.
glm::dvec3 lookup(const Environment& environment, const glm::dvec3& direction);

}  // namespace rayscope::shading
