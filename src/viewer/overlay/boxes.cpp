#include "viewer/overlay/boxes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace rayscope::viewer {

namespace {

/// Boxes with a smaller diagonal are drawn as strokes, at most one per square of this many pixels.
constexpr double kSmallestBox = 4.0;

/// The squares of the picture that have a stroke.
class StrokeGrid {
  public:
    explicit StrokeGrid(const ViewFrame& frame)
        : columns_(static_cast<std::size_t>(frame.width / kSmallestBox) + 1),
          taken_(columns_ * (static_cast<std::size_t>(frame.height / kSmallestBox) + 1)) {}

    /// Whether the square had no stroke; it has one now. `pixel` lies in the picture.
    bool take(glm::dvec2 pixel) {
        const auto column = static_cast<std::size_t>(pixel.x / kSmallestBox);
        const auto row = static_cast<std::size_t>(pixel.y / kSmallestBox);
        const bool wasFree = !taken_[row * columns_ + column];
        taken_[row * columns_ + column] = true;
        return wasFree;
    }

  private:
    std::size_t columns_;
    std::vector<bool> taken_;
};

/// Whether a disc of `radius` pixels around `pixel` overlaps the picture.
bool overlaps(const ViewFrame& frame, glm::dvec2 pixel, double radius) {
    return pixel.x > -radius && pixel.y > -radius && pixel.x < frame.width + radius &&
           pixel.y < frame.height + radius;
}

/// A box that overlaps the picture.
struct VisibleBox {
    const OverlayBox* box;
    glm::dvec2 pixel;  ///< of its centre; undefined around or close to the camera
    double size;       ///< of its diagonal, in pixels; infinite around or close to the camera
};

std::vector<VisibleBox> visibleBoxes(const OverlayBoxes& boxes, const ViewFrame& frame) {
    std::vector<VisibleBox> visible;
    visible.reserve(boxes.size());
    const glm::dvec2 middle(0.5 * frame.width, 0.5 * frame.height);
    const double focal = middle.y / frame.tanHalfFov;  // pixels at depth 1
    for (const OverlayBox& box : boxes) {
        const glm::dvec3 lower(box.lower), upper(box.upper);
        const glm::dvec3 toCenter = 0.5 * (lower + upper) - frame.eye;
        const double radius = 0.5 * glm::distance(lower, upper);
        const double depth = glm::dot(toCenter, frame.forward);
        if (depth < -radius) continue;
        if (depth <= 2.0 * radius) {
            visible.push_back({&box, glm::dvec2(0.0), std::numeric_limits<double>::infinity()});
            continue;
        }
        const double scale = focal / depth;
        const glm::dvec2 offset(glm::dot(toCenter, frame.right), -glm::dot(toCenter, frame.up));
        const glm::dvec2 pixel = middle + scale * offset;
        const double size = 2.0 * radius * scale;
        if (overlaps(frame, pixel, size)) visible.push_back({&box, pixel, size});
    }
    return visible;
}

/// Boxes of at least this size are drawn with all edges.
double minWholeSize(const std::vector<VisibleBox>& visible, std::size_t maxWholeBoxes) {
    std::vector<double> sizes;
    for (const VisibleBox& box : visible)
        if (box.size >= kSmallestBox) sizes.push_back(box.size);
    if (sizes.size() <= maxWholeBoxes) return kSmallestBox;
    const auto limit = sizes.begin() + static_cast<std::ptrdiff_t>(maxWholeBoxes);
    std::nth_element(sizes.begin(), limit, sizes.end(), std::greater<>());
    return std::nextafter(*limit, std::numeric_limits<double>::infinity());
}

}  // namespace

BoxSelection selectBoxes(const OverlayBoxes& boxes, const ViewFrame& frame, std::size_t maxWholeBoxes) {
    BoxSelection drawn;
    StrokeGrid strokes(frame);
    const std::vector<VisibleBox> visible = visibleBoxes(boxes, frame);
    const double whole = minWholeSize(visible, maxWholeBoxes);
    drawn.whole.reserve(std::min(visible.size(), maxWholeBoxes));
    for (const auto& [box, pixel, size] : visible) {
        if (size >= kSmallestBox) ++drawn.large;
        if (size >= whole) {
            drawn.whole.push_back(*box);
        } else if (overlaps(frame, pixel, 0.0) && strokes.take(pixel)) {
            drawn.strokes.push_back({box->lower, box->upper, box->color, LineStyle::Solid, box->width});
        }
    }
    return drawn;
}

}  // namespace rayscope::viewer
