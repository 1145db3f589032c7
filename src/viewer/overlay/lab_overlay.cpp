#include "viewer/overlay/lab_overlay.h"

#include <cmath>

#include "math/vectors.h"
#include "viewer/overlay/palette.h"

namespace rayscope::viewer {

OverlayLines labFailureLines(const LabResult& result, LabMethod method) {
    OverlayLines lines;
    for (const LabFailure& failure : result.failures) {
        if (failure.method != method) continue;
        const Ray ray = rayInScene(result, failure);
        const double length = math::length(ray.direction);
        if (!(length > 0.0) || !std::isfinite(length)) continue;
        const bool atSharedEdge =
            failure.kind == LabFailureKind::Leak || failure.kind == LabFailureKind::DoubleHit;
        const double reach = (atSharedEdge ? 1.0 : 0.05) * result.size / length;
        const glm::vec3 to(glm::dvec3(ray.origin) + reach * glm::dvec3(ray.direction));
        lines.push_back(
            {ray.origin, to,
             failure.kind == LabFailureKind::DoubleHit ? palette::kBelowSurfaceRay : palette::kMissedRay,
             atSharedEdge ? LineStyle::Solid : LineStyle::Dashed});
    }
    return lines;
}

}  // namespace rayscope::viewer
