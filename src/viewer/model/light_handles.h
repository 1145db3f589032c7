#pragma once
// Points of lights that can be dragged, and the three-axis handle that drags them. Pure functions.
#include <rayscope/scene.h>
#include <optional>
#include <vector>

#include "viewer/model/projection.h"

namespace rayscope::viewer {

/// Handle 0 moves the whole light; the others are the two ends of a segment, or the corner and the two edge
/// ends of a parallelogram.
std::vector<glm::vec3> handlePositions(const Light& light);
Light withHandleMoved(const Light& light, int handle, glm::vec3 newPosition);
const char* handleName(const Light& light, int handle);

/// The parts of the three-axis handle.
enum class HandlePart { X, Y, Z, Free };
constexpr glm::dvec3 axisOf(HandlePart handlePart) {
    return {handlePart == HandlePart::X ? 1.0 : 0.0, handlePart == HandlePart::Y ? 1.0 : 0.0,
            handlePart == HandlePart::Z ? 1.0 : 0.0};
}

/// Lengths in pixels of the picture.
struct HandleSize {
    double axis = 70.0;  ///< length of an axis
    double reach = 8.0;  ///< a cursor within this distance is on the handle
};

/// The size at this UI scale.
inline HandleSize handleSize(float scale) {
    return {70.0 * static_cast<double>(scale), 8.0 * static_cast<double>(scale)};
}

/// The end of an axis; its length is `size.axis` pixels if it is not foreshortened.
glm::dvec3 axisEnd(const ViewFrame& frame, glm::dvec3 center, HandlePart handlePart, const HandleSize& size);

/// The part under the cursor, the nearest one if several are within reach.
std::optional<HandlePart> pickHandlePart(const ViewFrame& frame, glm::dvec3 center, glm::dvec2 cursor,
                                         const HandleSize& size);

/// The new centre of a handle that was dragged from `grabbed` to `cursor`: on an axis the point nearest to
/// the ray through the cursor, else in the plane through `center` that faces the viewer.
glm::dvec3 dragged(const ViewFrame& frame, glm::dvec3 center, HandlePart handlePart, glm::dvec2 grabbed,
                   glm::dvec2 cursor);

/// The handle within `reach` pixels of the cursor, or else the light whose outline is.
struct LightPick {
    int light = -1, handle = 0;
};
std::optional<LightPick> pickLight(const ViewFrame& frame, const std::vector<Light>& lights,
                                   glm::dvec2 cursor, double reach);

}  // namespace rayscope::viewer
