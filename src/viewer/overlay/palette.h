#pragma once
// The colours of the overlays, sRGB, after Okabe and Ito's palette, which is suitable for red-green colour
// blindness. Elements that are shown together also differ in line style or width.
#include <rayscope/vector.h>

namespace rayscope::viewer::palette {

// Rays.
inline constexpr glm::vec4 kCameraRay{0.95f, 0.90f, 0.35f, 1.0f};
inline constexpr glm::vec4 kReflectedRay{0.34f, 0.71f, 0.91f, 1.0f};
inline constexpr glm::vec4 kTransmittedRay{0.85f, 0.55f, 0.80f, 1.0f};
inline constexpr glm::vec4 kMissedRay{0.84f, 0.25f, 0.10f, 1.0f};
inline constexpr glm::vec4 kOccludedRay{0.95f, 0.16f, 0.12f, 0.9f};
inline constexpr glm::vec4 kBehindSurfaceRay{0.55f, 0.57f, 0.60f, 0.6f};
inline constexpr glm::vec4 kNormal{0.10f, 0.78f, 0.55f, 1.0f};
inline constexpr glm::vec4 kVertexNormal{0.55f, 0.90f, 0.80f, 1.0f};
inline constexpr glm::vec4 kBelowSurfaceRay{0.75f, 0.40f, 0.85f, 0.9f};
inline constexpr glm::vec4 kHalo{1.0f, 1.0f, 1.0f, 0.45f};

inline constexpr glm::vec4 kGlossySquare{0.75f, 0.40f, 0.85f, 1.0f};
inline constexpr glm::vec4 kLens{0.10f, 0.78f, 0.55f, 1.0f};

// Hierarchies.
inline constexpr glm::vec4 kLevelBox{0.95f, 0.96f, 0.98f, 0.85f};
inline constexpr glm::vec4 kReferenceBox{0.90f, 0.30f, 0.10f, 0.9f};
inline constexpr glm::vec4 kSelected{0.34f, 0.71f, 0.91f, 1.0f};
inline constexpr glm::vec4 kChildBox{0.34f, 0.71f, 0.91f, 0.8f};
inline constexpr glm::vec4 kLeaf{0.95f, 0.65f, 0.10f, 1.0f};
inline constexpr glm::vec4 kLeafPrimitive{0.95f, 0.90f, 0.25f, 1.0f};

// A traversal through a hierarchy.
inline constexpr glm::vec4 kVisitedBox{0.10f, 0.78f, 0.55f, 0.9f};
inline constexpr glm::vec4 kCulledBox{0.75f, 0.40f, 0.85f, 0.9f};
inline constexpr glm::vec4 kMissedBox{0.55f, 0.57f, 0.60f, 0.6f};
inline constexpr glm::vec4 kPushedBox{0.95f, 0.65f, 0.10f, 0.9f};
inline constexpr glm::vec4 kHitPrimitive{0.95f, 0.90f, 0.25f, 1.0f};

}  // namespace rayscope::viewer::palette
