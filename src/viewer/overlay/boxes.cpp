#include "viewer/overlay/boxes.h"

#include <cmath>

namespace rayscope::viewer {

namespace {

/// Boxes of a smaller diagonal are drawn as a stroke, at most one in a square of this many pixels.
constexpr double kSmallestBox = 4.0;

/// Which spots of the picture have a stroke already.
class Spots {
  public:
    explicit Spots(const ViewFrame& frame)
        : columns_(static_cast<std::size_t>(frame.width / kSmallestBox) + 1),
          taken_(columns_ * (static_cast<std::size_t>(frame.height / kSmallestBox) + 1)) {}

    /// Whether the spot was free until now. `pixel` lies in the picture.
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

/// Whether a ball of `radius` pixels around `pixel` reaches into the picture.
bool reaches(const ViewFrame& frame, glm::dvec2 pixel, double radius) {
    return pixel.x > -radius && pixel.y > -radius && pixel.x < frame.width + radius &&
           pixel.y < frame.height + radius;
}

}  // namespace

OverlayLines boxLines(const OverlayBoxes& boxes, const ViewFrame& frame) {
    OverlayLines lines;
    Spots spots(frame);
    for (const OverlayBox& box : boxes) {
        const glm::dvec3 lower(box.lower), upper(box.upper), center = 0.5 * (lower + upper);
        const double radius = 0.5 * glm::distance(lower, upper);
        const double depth = glm::dot(center - frame.eye, frame.forward);
        // The camera may stand inside; what is wholly behind it is not seen.
        const bool near = depth <= 2.0 * radius;
        if (near && depth < -radius) continue;
        if (!near) {
            const glm::dvec2 pixel = *frame.project(center);
            const double reach = 2.0 * radius / frame.unitsPerPixelAt(center);
            if (!reaches(frame, pixel, reach)) continue;
            if (reach < kSmallestBox) {
                if (reaches(frame, pixel, 0.0) && spots.take(pixel))
                    lines.push_back({box.lower, box.upper, box.color, LineStyle::Solid, box.width});
                continue;
            }
        }
        appendBox(lines, box.lower, box.upper, box.color, box.style, box.width);
    }
    return lines;
}

}  // namespace rayscope::viewer
