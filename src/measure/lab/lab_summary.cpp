#include "measure/lab/lab_summary.h"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::measure {

namespace {

/// Finds the last test point of a row before the first failing one, and that one; null where there is none.
void findFirstFailure(const std::vector<const LabTestPoint*>& row, LabMethod method,
                      const LabTestPoint*& last, const LabTestPoint*& next) {
    for (const LabTestPoint* testPoint : row) {
        if (!testPoint->of(method).passed()) {
            next = testPoint;
            return;
        }
        last = testPoint;
    }
}

LabRange rangeOf(const std::vector<LabTestPoint>& testPoints, LabMethod method) {
    LabRange range;
    std::vector<const LabTestPoint*> smaller, larger, farther;  // by distance from the untransformed scene
    for (const LabTestPoint& testPoint : testPoints) {
        range.failingTestPoints += !testPoint.of(method).passed();
        if (testPoint.transform.offset == 0.0 && testPoint.transform.scale < 0)
            smaller.insert(smaller.begin(), &testPoint);
        if (testPoint.transform.offset == 0.0 && testPoint.transform.scale > 0) larger.push_back(&testPoint);
        if (testPoint.transform.offset > 0.0 && testPoint.transform.scale == 0) farther.push_back(&testPoint);
        if (testPoint.transform.offset == 0.0 && testPoint.transform.scale == 0)
            range.soundUntransformed = testPoint.of(method).passed();
    }
    if (!range.soundUntransformed) return range;
    const LabTestPoint *last = nullptr, *next = nullptr;
    findFirstFailure(smaller, method, last, next);
    if (last) range.lowestScale = last->transform.scale;
    if (next) range.failsBelow = next->transform.scale;
    last = next = nullptr;
    findFirstFailure(larger, method, last, next);
    if (last) range.highestScale = last->transform.scale;
    if (next) range.failsAbove = next->transform.scale;
    last = next = nullptr;
    findFirstFailure(farther, method, last, next);
    if (last) range.largestOffset = last->transform.offset;
    if (next) range.failsBeyond = next->transform.offset;
    return range;
}

}  // namespace

void summarizeLab(LabResult& result) {
    for (int i = 0; i < static_cast<int>(kLabMethods.size()); ++i)
        result.ranges[static_cast<std::size_t>(i)] = rangeOf(result.testPoints, static_cast<LabMethod>(i));
    for (const LabTestPoint& testPoint : result.testPoints) {
        if (testPoint.transform.scale != 0) continue;
        if (testPoint.degenerate > 0) break;
        result.meshOffset = testPoint.transform.offset;
    }
    if (result.sharedEdges == 0)
        result.remarks.emplace_back(
            "no edge is shared by two triangles, so no rays were aimed at shared edges");
    if (result.spheres > 0)
        result.remarks.push_back(
            fmt::format("{} spheres were left out: only triangles are tested", result.spheres));
    if (result.interrupted)
        result.remarks.push_back(fmt::format("interrupted after {} test points", result.testPoints.size()));
}

}  // namespace rayscope::measure

namespace rayscope {

LabCounts LabResult::total(LabMethod method) const {
    LabCounts sum;
    for (const LabTestPoint& testPoint : testPoints) {
        const LabCounts& c = testPoint.of(method);
        sum.sharedEdgeRays += c.sharedEdgeRays, sum.leaks += c.leaks, sum.doubleHits += c.doubleHits;
        sum.spawned += c.spawned, sum.falseHits += c.falseHits, sum.offsetSurfaceRays += c.offsetSurfaceRays,
            sum.missedSurfaces += c.missedSurfaces;
        sum.tRatio = std::max(sum.tRatio, c.tRatio);
        sum.weightRatio = std::max(sum.weightRatio, c.weightRatio);
    }
    return sum;
}

}  // namespace rayscope
