#include "viewer/overlay/line_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace rayscope::viewer {

namespace {

constexpr double kCostOfALine = 30.0;
/// Lines whose ends lie in the same squares of this many pixels look the same.
constexpr double kSamePlace = 2.0;

using PixelSegment = std::array<glm::dvec2, 2>;

/// The length of the part of a segment that lies in the picture (Liang and Barsky's clipping).
double lengthInside(const PixelSegment& segment, const ViewFrame& frame) {
    const glm::dvec2 along = segment[1] - segment[0], size(frame.width, frame.height);
    double enter = 0.0, leave = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double start = segment[0][axis], step = along[axis];
        if (step == 0.0) {
            if (start < 0.0 || start > size[axis]) return 0.0;
            continue;
        }
        const double a = -start / step, b = (size[axis] - start) / step;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter < leave ? (leave - enter) * glm::length(along) : 0.0;
}

double costOf(const OverlayLine& line, const ViewFrame& frame) {
    const auto segment = frame.projectSegment(glm::dvec3(line.from), glm::dvec3(line.to));
    return kCostOfALine + (segment ? lengthInside(*segment, frame) : 0.0);
}

/// Where a line appears and what it looks like, rounded.
using Appearance = std::array<long, 6>;

Appearance appearanceOf(const OverlayLine& line, const PixelSegment& segment) {
    const auto square = [](double pixel) { return std::lround(std::clamp(pixel / kSamePlace, -1e6, 1e6)); };
    const auto level = [&](int channel) { return std::lround(line.color[channel] * 15.0f); };
    const long color = ((level(0) * 16 + level(1)) * 16 + level(2)) * 16 + level(3);
    return {
        square(segment[0].x),         square(segment[0].y), square(segment[1].x), square(segment[1].y), color,
        static_cast<long>(line.style)};
}

/// Multiples of the golden ratio fill 0 … 1 evenly, however few are taken and whatever repeats in the list.
double placeInOrder(std::size_t index) {
    constexpr double kGoldenRatio = 0.6180339887498949;
    const double multiple = static_cast<double>(index) * kGoldenRatio;
    return multiple - std::floor(multiple);
}

struct Candidate {
    std::size_t index;
    double cost;
};

/// Lines that are not bold and that are seen, one for each place.
std::vector<Candidate> distinctLines(const OverlayLines& lines, const ViewFrame& frame) {
    std::vector<Candidate> distinct;
    std::set<Appearance> known;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (isBold(lines[i])) continue;
        const auto segment = frame.projectSegment(glm::dvec3(lines[i].from), glm::dvec3(lines[i].to));
        if (!segment || !known.insert(appearanceOf(lines[i], *segment)).second) continue;
        const double length = lengthInside(*segment, frame);
        if (length > 0.0) distinct.push_back({i, kCostOfALine + length});
    }
    return distinct;
}

}  // namespace

double drawingCost(const OverlayLines& lines, const ViewFrame& frame) {
    double cost = 0.0;
    for (const OverlayLine& line : lines) cost += costOf(line, frame);
    return cost;
}

OverlayLines chooseLines(const OverlayLines& lines, const ViewFrame& frame, double mostPixels) {
    if (!std::isfinite(mostPixels) || drawingCost(lines, frame) <= mostPixels) return lines;
    const std::vector<Candidate> candidates = distinctLines(lines, frame);
    double all = 0.0, left = mostPixels;
    for (const Candidate& candidate : candidates) all += candidate.cost;
    for (const OverlayLine& line : lines)
        if (isBold(line)) left -= costOf(line, frame);
    const double share = all > 0.0 ? std::max(left, 0.0) / all : 1.0;

    std::vector<bool> kept(lines.size());
    for (const Candidate& candidate : candidates)
        kept[candidate.index] = placeInOrder(candidate.index) < share;
    OverlayLines chosen;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (kept[i] || isBold(lines[i])) chosen.push_back(lines[i]);
    return chosen;
}

}  // namespace rayscope::viewer
