#include "measure/lab/summary.h"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::measure {

namespace {

/// Follows testPoints away from the middle: `last` becomes the last passed one, `next` the first that fails.
void follow(const std::vector<const LabTestPoint*>& row, LabMethod method, const LabTestPoint*& last,
            const LabTestPoint*& next) {
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
    std::vector<const LabTestPoint*> smaller, larger, farther;  // nearest to the middle first
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
    follow(smaller, method, last, next);
    if (last) range.lowestScale = last->transform.scale;
    if (next) range.failsBelow = next->transform.scale;
    last = next = nullptr;
    follow(larger, method, last, next);
    if (last) range.highestScale = last->transform.scale;
    if (next) range.failsAbove = next->transform.scale;
    last = next = nullptr;
    follow(farther, method, last, next);
    if (last) range.largestOffset = last->transform.offset;
    if (next) range.failsBeyond = next->transform.offset;
    return range;
}

}  // namespace

void summarize(LabResult& result) {
    for (int i = 0; i < static_cast<int>(kLabMethods.size()); ++i)
        result.ranges[static_cast<std::size_t>(i)] = rangeOf(result.testPoints, static_cast<LabMethod>(i));
    for (const LabTestPoint& testPoint : result.testPoints) {
        if (testPoint.transform.scale != 0) continue;
        if (testPoint.degenerate > 0) break;
        result.meshOffset = testPoint.transform.offset;
    }
    if (result.sharedEdges == 0)
        result.remarks.emplace_back("no edge is shared by two triangles, so no ray could be aimed at a seam");
    if (result.spheres > 0)
        result.remarks.push_back(
            fmt::format("{} spheres were left out: the laboratory shoots at triangles", result.spheres));
    if (result.interrupted)
        result.remarks.push_back(fmt::format("stopped early, after {} cells", result.testPoints.size()));
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
