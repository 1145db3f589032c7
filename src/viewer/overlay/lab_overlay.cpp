#include "viewer/overlay/lab_overlay.h"

#include <cmath>

#include "viewer/overlay/palette.h"

namespace rayscope::viewer {

OverlayLines labFailureLines(const LabResult& result, LabMethod method) {
    OverlayLines lines;
    const auto size = static_cast<float>(result.size);
    for (const LabFailure& failure : result.failures) {
        if (failure.method != method) continue;
        const Ray ray = rayInScene(result, failure);
        const float length = glm::length(ray.direction);
        if (!(length > 0.0f) || !std::isfinite(length)) continue;
        const bool atSharedEdge =
            failure.kind == LabFailureKind::Leak || failure.kind == LabFailureKind::DoubleHit;
        const glm::vec3 to = ray.origin + (atSharedEdge ? 1.0f : 0.05f) * size / length * ray.direction;
        lines.push_back(
            {ray.origin, to,
             failure.kind == LabFailureKind::DoubleHit ? palette::kBelowSurfaceRay : palette::kMissedRay,
             atSharedEdge ? LineStyle::Solid : LineStyle::Dashed});
    }
    return lines;
}

}  // namespace rayscope::viewer
