#pragma once
// Projection of the scene to the picture with the camera of the tracer, for the rasterised view, the overlays
// and the handles.
#include <rayscope/scene.h>
#include <array>
#include <optional>

namespace rayscope::viewer {

/// A camera as an orthonormal frame. Pixels count from the top left corner of the picture; the centre of
/// pixel (x, y) is (x + 0.5, y + 0.5).
struct ViewFrame {
    glm::dvec3 eye{0.0}, right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, forward{0.0, 0.0, -1.0};
    double tanHalfFov = 1.0;  ///< of the vertical angle
    int width = 1, height = 1;

    double aspect() const { return static_cast<double>(width) / height; }

    /// Unit direction from the eye through a point of the picture.
    glm::dvec3 directionThrough(glm::dvec2 pixel) const;
    /// Pixel coordinates of `point`; nothing if it is not in front of the camera.
    std::optional<glm::dvec2> project(glm::dvec3 point) const;
    /// Pixel coordinates of the ends of the part of a segment in front of the camera; nothing if there is
    /// none.
    std::optional<std::array<glm::dvec2, 2>> projectSegment(glm::dvec3 a, glm::dvec3 b) const;
    /// Size of a pixel, in scene units, at the depth of `point`.
    double unitsPerPixelAt(glm::dvec3 point) const;
};

/// The frame of the tracer's camera, also if it looks along `up`.
ViewFrame viewFrame(const CameraDescription& camera, int width, int height);

/// From a point to the nearest point of the segment a b, for instance in pixels.
double distanceToSegment(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b);

/// The unit in which lengths about as large as `size` are drawn: 1 for ordinary ones, else a power of two
/// near them, because graphics hardware treats floats below 2^-126 as 0 and squares lengths in float.
double drawingUnit(double size);

/// OpenGL clip coordinates, up to a factor common to all four, with the near and far plane fitted to
/// `bounds`.
glm::mat4 viewProjection(const ViewFrame& frame, const SceneBounds& bounds);

}  // namespace rayscope::viewer
