#include "viewer/overlay/line_selection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_set>

namespace rayscope::viewer {

namespace {

constexpr double kLineCost = 30.0;
/// Lines with ends in the same squares of this many pixels have the same appearance.
constexpr double kPixelGrid = 2.0;

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

/// Pixel coordinates, colour and style of a line, quantised.
using AppearanceKey = std::array<long, 6>;

AppearanceKey appearanceKeyOf(const OverlayLine& line, const PixelSegment& segment) {
    const auto square = [](double pixel) { return std::lround(std::clamp(pixel / kPixelGrid, -1e6, 1e6)); };
    const auto level = [&](int channel) { return std::lround(line.color[channel] * 15.0f); };
    const long color = ((level(0) * 16 + level(1)) * 16 + level(2)) * 16 + level(3);
    return {
        square(segment[0].x),         square(segment[0].y), square(segment[1].x), square(segment[1].y), color,
        static_cast<long>(line.style)};
}

/// FNV-1a over the numbers instead of bytes.
struct AppearanceKeyHash {
    std::size_t operator()(const AppearanceKey& key) const {
        std::uint64_t hash = 14695981039346656037u;
        for (const long part : key) hash = (hash ^ static_cast<std::uint64_t>(part)) * 1099511628211u;
        return static_cast<std::size_t>(hash ^ hash >> 32);
    }
};

/// Multiples of the golden ratio modulo 1: every prefix is evenly distributed, and periodic lists do not
/// alias.
double goldenSequence(std::size_t index) {
    constexpr double kGoldenRatio = 0.6180339887498949;
    const double multiple = static_cast<double>(index) * kGoldenRatio;
    return multiple - std::floor(multiple);
}

/// The projection of a line, if it is in front of the camera, and its drawing cost.
struct ProjectedLine {
    std::optional<PixelSegment> segment;
    double cost = kLineCost;
};

std::vector<ProjectedLine> projectedLines(const OverlayLines& lines, const ViewFrame& frame) {
    std::vector<ProjectedLine> projected;
    projected.reserve(lines.size());
    for (const OverlayLine& line : lines) {
        ProjectedLine one{frame.projectSegment(glm::dvec3(line.from), glm::dvec3(line.to))};
        if (one.segment) one.cost += lengthInside(*one.segment, frame);
        projected.push_back(one);
    }
    return projected;
}

double sumOf(const std::vector<ProjectedLine>& projected) {
    double cost = 0.0;
    for (const ProjectedLine& line : projected) cost += line.cost;
    return cost;
}

/// Indices of the visible lines that are not bold, one per appearance.
std::vector<std::size_t> distinctLines(const OverlayLines& lines,
                                       const std::vector<ProjectedLine>& projected) {
    std::vector<std::size_t> distinct;
    std::unordered_set<AppearanceKey, AppearanceKeyHash> appearances(2 * lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool inPicture = projected[i].segment && projected[i].cost > kLineCost;
        if (isBold(lines[i]) || !inPicture) continue;
        if (appearances.insert(appearanceKeyOf(lines[i], *projected[i].segment)).second)
            distinct.push_back(i);
    }
    return distinct;
}

}  // namespace

double drawingCost(const OverlayLines& lines, const ViewFrame& frame) {
    return sumOf(projectedLines(lines, frame));
}

OverlayLines selectLines(const OverlayLines& lines, const ViewFrame& frame, double maxPixels) {
    if (!std::isfinite(maxPixels)) return lines;
    const std::vector<ProjectedLine> projected = projectedLines(lines, frame);
    if (sumOf(projected) <= maxPixels) return lines;
    const std::vector<std::size_t> candidates = distinctLines(lines, projected);
    double all = 0.0, left = maxPixels;
    for (const std::size_t i : candidates) all += projected[i].cost;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (isBold(lines[i])) left -= projected[i].cost;
    const double fraction = all > 0.0 ? std::max(left, 0.0) / all : 1.0;

    std::vector<bool> kept(lines.size());
    for (const std::size_t i : candidates) kept[i] = goldenSequence(i) < fraction;
    OverlayLines chosen;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (kept[i] || isBold(lines[i])) chosen.push_back(lines[i]);
    return chosen;
}

}  // namespace rayscope::viewer
