#include "measure/lab/lab_summary.h"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::measure {

namespace {

/// Follows cells away from the middle: `last` becomes the last sound one, `next` the first that fails.
void follow(const std::vector<const LabCell*>& row, LabMethod method, const LabCell*& last,
            const LabCell*& next) {
    for (const LabCell* cell : row) {
        if (!cell->of(method).sound()) {
            next = cell;
            return;
        }
        last = cell;
    }
}

LabRange rangeOf(const std::vector<LabCell>& cells, LabMethod method) {
    LabRange range;
    std::vector<const LabCell*> smaller, larger, farther;  // nearest to the middle first
    for (const LabCell& cell : cells) {
        range.failingCells += !cell.of(method).sound();
        if (cell.place.offset == 0.0 && cell.place.scale < 0) smaller.insert(smaller.begin(), &cell);
        if (cell.place.offset == 0.0 && cell.place.scale > 0) larger.push_back(&cell);
        if (cell.place.offset > 0.0 && cell.place.scale == 0) farther.push_back(&cell);
        if (cell.place.offset == 0.0 && cell.place.scale == 0) range.soundAsItIs = cell.of(method).sound();
    }
    if (!range.soundAsItIs) return range;
    const LabCell *last = nullptr, *next = nullptr;
    follow(smaller, method, last, next);
    if (last) range.lowestScale = last->place.scale;
    if (next) range.failsBelow = next->place.scale;
    last = next = nullptr;
    follow(larger, method, last, next);
    if (last) range.highestScale = last->place.scale;
    if (next) range.failsAbove = next->place.scale;
    last = next = nullptr;
    follow(farther, method, last, next);
    if (last) range.largestOffset = last->place.offset;
    if (next) range.failsBeyond = next->place.offset;
    return range;
}

}  // namespace

void summarize(LabResult& result) {
    for (int i = 0; i < static_cast<int>(kLabMethods.size()); ++i)
        result.ranges[static_cast<std::size_t>(i)] = rangeOf(result.cells, static_cast<LabMethod>(i));
    for (const LabCell& cell : result.cells) {
        if (cell.place.scale != 0) continue;
        if (cell.collapsed > 0) break;
        result.meshOffset = cell.place.offset;
    }
    if (result.sharedEdges == 0)
        result.remarks.emplace_back("no edge is shared by two triangles, so no ray could be aimed at a seam");
    if (result.spheres > 0)
        result.remarks.push_back(
            fmt::format("{} spheres were left out: the laboratory shoots at triangles", result.spheres));
    if (result.interrupted)
        result.remarks.push_back(fmt::format("stopped early, after {} cells", result.cells.size()));
}

}  // namespace rayscope::measure

namespace rayscope {

LabCounts LabResult::total(LabMethod method) const {
    LabCounts sum;
    for (const LabCell& cell : cells) {
        const LabCounts& c = cell.of(method);
        sum.aimed += c.aimed, sum.leaks += c.leaks, sum.doubleHits += c.doubleHits;
        sum.spawned += c.spawned, sum.falseHits += c.falseHits, sum.plates += c.plates, sum.lost += c.lost;
        sum.tRatio = std::max(sum.tRatio, c.tRatio);
        sum.weightRatio = std::max(sum.weightRatio, c.weightRatio);
    }
    return sum;
}

}  // namespace rayscope
