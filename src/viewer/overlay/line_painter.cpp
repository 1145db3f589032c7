#include "viewer/overlay/line_painter.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace rayscope::viewer {

namespace {

/// Depth bias, so that lines on a surface are visible: depths have 24 bits.
constexpr float kStepOfDepth = 1.0f / 8388608.0f;
/// Pixel coordinates are fixed-point with 16 fractional bits. Rounding accumulates to at most 1/8 pixel over
/// the longest line, hence the margin at the border.
constexpr int kFraction = 16;
constexpr float kMargin = 0.25f;

/// A colour prepared for blending, and the line style.
struct Ink {
    std::uint32_t redBlue, green;
    std::uint32_t opacity, hiddenOpacity;  // of 256
    float period, on;                      // pixels, and the fraction that is drawn; solid if the period is 0
};

Ink inkOf(const glm::vec4& color, LineStyle style, const PaintOptions& look) {
    const auto level = [](float value, float most) {
        return static_cast<std::uint32_t>(std::clamp(value, 0.0f, 1.0f) * most + 0.5f);
    };
    const float period = style == LineStyle::Solid ? 0.0f : style == LineStyle::Dashed ? 10.0f : 5.0f;
    const float on = style == LineStyle::Dashed ? 0.6f : 0.4f;
    return {level(color.r, 255.0f) | level(color.b, 255.0f) << 16,
            level(color.g, 255.0f) << 8,
            level(color.a, 256.0f),
            level(color.a * look.hiddenOpacity, 256.0f),
            period * look.unit,
            on};
}

std::uint32_t mixed(std::uint32_t below, const Ink& ink, std::uint32_t opacity) {
    const std::uint32_t rest = 256 - opacity;
    const std::uint32_t redBlue = ((below & 0xff00ffu) * rest + ink.redBlue * opacity) >> 8 & 0xff00ffu;
    const std::uint32_t green = ((below & 0x00ff00u) * rest + ink.green * opacity) >> 8 & 0x00ff00u;
    return (below & 0xff000000u) | redBlue | green;
}

class Painter {
  public:
    struct Rows {
        int begin, end;
    };
    Painter(PaintCanvas& canvas, const PaintOptions& look, Rows rows)
        : canvas_(canvas),
          look_(look),
          rows_(rows),
          size_(static_cast<float>(canvas.width), static_cast<float>(canvas.height)),
          hides_(!canvas.depth.empty()) {}

    void paint(const OverlayLine& line) {
        paint(look_.viewProjection * glm::vec4(line.from, 1.0f),
              look_.viewProjection * glm::vec4(line.to, 1.0f), inkOf(line.color, line.style, look_));
    }

    /// Projects each corner once instead of once per edge.
    void paint(const OverlayBox& box) {
        const Ink ink = inkOf(box.color, box.style, look_);
        const glm::vec3 extent = box.upper - box.lower;
        std::array<glm::vec4, 8> corners;
        corners[0] = look_.viewProjection * glm::vec4(box.lower, 1.0f);
        for (int axis = 0; axis < 3; ++axis) {
            const glm::vec4 edge = look_.viewProjection[axis] * extent[axis];
            const std::size_t bit = std::size_t{1} << axis;
            for (std::size_t i = 0; i < bit; ++i) corners[i | bit] = corners[i] + edge;
        }
        if (std::all_of(corners.begin(), corners.end(), [this](const glm::vec4& c) { return isInside(c); })) {
            std::array<glm::vec3, 8> positions;
            for (std::size_t i = 0; i < 8; ++i) positions[i] = canvasPosition(corners[i]);
            forEachEdge([&](std::size_t a, std::size_t b) { draw(positions[a], positions[b], 0.0f, ink); });
        } else {
            forEachEdge([&](std::size_t a, std::size_t b) { paint(corners[a], corners[b], ink); });
        }
    }

  private:
    template <class Edge>
    static void forEachEdge(Edge&& edge) {
        for (std::size_t start = 0; start < 8; ++start)
            for (std::size_t axis = 1; axis < 8; axis *= 2)
                if (!(start & axis)) edge(start, start | axis);
    }

    /// Signed distances of a point in clip space to the six planes of the view frustum; positive inside.
    std::array<float, 6> insides(const glm::vec4& p) const {
        const glm::vec2 reach = (1.0f - 2.0f * kMargin / size_) * p.w;
        return {p.w + p.z, p.w - p.z, reach.x + p.x, reach.x - p.x, reach.y + p.y, reach.y - p.y};
    }
    bool isInside(const glm::vec4& p) const {
        const std::array<float, 6> inside = insides(p);
        return p.w > 0.0f && std::all_of(inside.begin(), inside.end(), [](float d) { return d > 0.0f; });
    }

    /// Pixels from the lower left corner, and the depth from 0 to 1.
    glm::vec3 canvasPosition(const glm::vec4& p) const {
        const float perW = 1.0f / p.w;
        return {0.5f * (p.x * perW + 1.0f) * size_.x, 0.5f * (p.y * perW + 1.0f) * size_.y,
                0.5f * (p.z * perW + 1.0f)};
    }

    void paint(const glm::vec4& from, const glm::vec4& to, const Ink& ink) {
        const std::array<float, 6> start = insides(from), end = insides(to);
        float enter = 0.0f, leave = 1.0f, beforeCamera = 0.0f;
        for (std::size_t plane = 0; plane < 6; ++plane) {
            if (start[plane] < 0.0f && end[plane] < 0.0f) return;
            const float cut = start[plane] / (start[plane] - end[plane]);
            if (start[plane] < 0.0f) enter = std::max(enter, cut);
            if (end[plane] < 0.0f) leave = std::min(leave, cut);
            if (plane == 0) beforeCamera = enter;
        }
        if (!(enter < leave)) return;
        const glm::vec3 a = canvasPosition(glm::mix(from, to, enter)),
                        b = canvasPosition(glm::mix(from, to, leave));
        // The pattern starts at the start of the line, even if that is outside the picture.
        float along = 0.0f;
        if (ink.period > 0.0f && enter > beforeCamera)
            along = glm::distance(glm::vec2(canvasPosition(glm::mix(from, to, beforeCamera))), glm::vec2(a));
        draw(a, b, along, ink);
    }

    bool isInCanvas(const glm::vec3& position) const {
        return position.x > 0.0f && position.x < size_.x && position.y > 0.0f && position.y < size_.y;
    }

    void draw(const glm::vec3& a, const glm::vec3& b, float along, const Ink& ink) {
        if (!isInCanvas(a) || !isInCanvas(b)) return;  // not finite
        const auto [lowest, highest] = std::minmax(a.y, b.y);
        if (highest + 1.0f < static_cast<float>(rows_.begin) || lowest - 1.0f > static_cast<float>(rows_.end))
            return;
        if (ink.period > 0.0f)
            hides_ ? rasterize<true, true>(a, b, along, ink) : rasterize<true, false>(a, b, along, ink);
        else
            hides_ ? rasterize<false, true>(a, b, along, ink) : rasterize<false, false>(a, b, along, ink);
    }

    /// The part of a line that lies in the rows, in steps of one pixel per row or column.
    struct Steps {
        int first, last;
    };
    Steps stepsInRows(int y, int stepY, int count) const {
        const int lowest = rows_.begin << kFraction, highest = (rows_.end << kFraction) - 1;
        if (stepY == 0) return y >= lowest && y <= highest ? Steps{0, count} : Steps{0, -1};
        const int enter = stepY > 0 ? lowest - y : y - highest;
        const int leave = stepY > 0 ? highest - y : y - lowest;
        const int step = std::abs(stepY);
        if (leave < 0) return {0, -1};
        return {enter > 0 ? (enter + step - 1) / step : 0, std::min(count, leave / step)};
    }

    template <bool kPattern, bool kHidden>
    void rasterize(const glm::vec3& a, const glm::vec3& b, float along, const Ink& ink) {
        const auto fixed = [](float value) { return static_cast<int>(value * (1 << kFraction)); };
        const int count = std::max(std::abs(static_cast<int>(b.x) - static_cast<int>(a.x)),
                                   std::abs(static_cast<int>(b.y) - static_cast<int>(a.y)));
        const float perStep = count > 0 ? 1.0f / static_cast<float>(count) : 0.0f;
        const int startX = fixed(a.x), stepX = fixed((b.x - a.x) * perStep);
        const int startY = fixed(a.y), stepY = fixed((b.y - a.y) * perStep);
        const float startZ = a.z - kStepOfDepth, stepZ = (b.z - a.z) * perStep;
        const float startPhase = kPattern ? std::fmod(along / ink.period, 1.0f) : 0.0f;
        const float stepPhase =
            kPattern ? glm::distance(glm::vec2(a), glm::vec2(b)) * perStep / ink.period : 0.0f;
        const auto width = static_cast<std::size_t>(canvas_.width);
        const Steps steps = stepsInRows(startY, stepY, count);
        for (int i = steps.first; i <= steps.last; ++i) {
            if constexpr (kPattern) {
                const float phase = startPhase + static_cast<float>(i) * stepPhase;
                if (phase - static_cast<float>(static_cast<int>(phase)) > ink.on) continue;
            }
            const std::size_t at = static_cast<std::size_t>((startY + i * stepY) >> kFraction) * width +
                                   static_cast<std::size_t>((startX + i * stepX) >> kFraction);
            const bool hidden = kHidden && startZ + static_cast<float>(i) * stepZ > canvas_.depth[at];
            canvas_.pixels[at] = mixed(canvas_.pixels[at], ink, hidden ? ink.hiddenOpacity : ink.opacity);
        }
    }

    PaintCanvas& canvas_;
    const PaintOptions& look_;
    Rows rows_;
    glm::vec2 size_;
    bool hides_;
};

/// Each thread draws all lines on its own rows, so each pixel is blended in the order of the list.
template <class Work>
void inBands(PaintCanvas& canvas, const PaintOptions& look, Work&& work) {
    if (canvas.pixels.empty()) return;
    const int bands = std::min({tbb::this_task_arena::max_concurrency(), canvas.height, 8});
    tbb::parallel_for(0, bands, [&](int band) {
        Painter painter(canvas, look, {canvas.height * band / bands, canvas.height * (band + 1) / bands});
        work(painter);
    });
}

}  // namespace

void paintLines(PaintCanvas& canvas, const OverlayLines& lines, const PaintOptions& look) {
    inBands(canvas, look, [&lines](Painter& painter) {
        for (const OverlayLine& line : lines) painter.paint(line);
    });
}

void paintBoxes(PaintCanvas& canvas, const OverlayBoxes& boxes, const PaintOptions& look) {
    inBands(canvas, look, [&boxes](Painter& painter) {
        for (const OverlayBox& box : boxes) painter.paint(box);
    });
}

}  // namespace rayscope::viewer
