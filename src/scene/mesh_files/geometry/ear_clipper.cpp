#include "scene/mesh_files/geometry/ear_clipper.h"

#include <algorithm>
#include <limits>

#include "scene/mesh_files/geometry/orientation.h"

namespace rayscope::scene {

namespace {

constexpr std::size_t kNotQueued = std::numeric_limits<std::size_t>::max();

}  // namespace

EarClipper::EarClipper(const std::vector<glm::dvec2>& outline)
    : flat_(outline),
      prev_(outline.size()),
      next_(outline.size()),
      queuedAt_(outline.size(), kNotQueued),
      left_(outline.size()),
      tree_(flat_, {}) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        next_[i] = static_cast<std::uint32_t>(i + 1 < outline.size() ? i + 1 : 0);
        prev_[next_[i]] = static_cast<std::uint32_t>(i);
    }
    buildTree();
}

void EarClipper::enqueue(std::uint32_t corner) {
    queuedAt_[corner] = queue_.size();
    queue_.push_back(corner);
}

void EarClipper::enqueueAll() {
    queue_.clear();
    head_ = 0;
    std::uint32_t corner = next_[start_];
    for (std::size_t i = 0; i < left_; ++i, corner = next_[corner]) enqueue(corner);
}

bool EarClipper::isEar(std::uint32_t corner, Rule rule) const {
    const glm::dvec2 a = flat_[prev_[corner]], b = flat_[corner], c = flat_[next_[corner]];
    if (isSpike(a, b, c)) return true;
    const double area = orientation(a, b, c);
    if (rule == Rule::Strict ? area <= 0.0 : area < 0.0) return false;
    if (area == 0.0) return true;
    // Whether the outline goes into the angle of the ear from another corner at its position.
    const auto entersAngle = [&](std::uint32_t other) {
        const auto isInside = [&](const glm::dvec2& p) {
            return orientation(a, b, p) > 0.0 && orientation(b, c, p) > 0.0;
        };
        return isInside(flat_[prev_[other]]) || isInside(flat_[next_[other]]);
    };
    const double least = rule == Rule::Strict ? 0.0 : std::numeric_limits<double>::min();
    return !tree_.anyInTriangle({a, b, c}, [&](std::uint32_t other, const glm::dvec2& p) {
        if (p == b) return other != corner && entersAngle(other);
        return orientation(c, a, p) >= least && orientation(a, b, p) >= least &&
               orientation(b, c, p) >= least && p != a && p != c;
    });
}

void EarClipper::cut(std::uint32_t corner, std::span<glm::uvec3> triangles) {
    const std::uint32_t before = prev_[corner], after = next_[corner];
    triangles[cut_++] = {before, corner, after};
    next_[before] = after;
    prev_[after] = before;
    start_ = before;
    tree_.remove(corner);
    queuedAt_[corner] = kNotQueued;
    --left_;
    // To the end of the queue: neighbouring ears would make long triangles with a common corner.
    enqueue(before);
    enqueue(after);
}

void EarClipper::buildTree() {
    std::vector<std::uint32_t> corners;
    corners.reserve(left_);
    std::uint32_t corner = start_;
    for (std::size_t i = 0; i < left_; ++i, corner = next_[corner]) corners.push_back(corner);
    tree_ = PointTree(flat_, corners);
    inTree_ = left_;
}

void EarClipper::cutEars(Rule rule, std::span<glm::uvec3> triangles,
                         const std::function<void(std::size_t)>& progress) {
    while (head_ < queue_.size() && left_ > 3) {
        const std::uint32_t corner = queue_[head_];
        const bool isValid = queuedAt_[corner] == head_++;
        if (isValid && isEar(corner, rule)) cut(corner, triangles);
        if (left_ * 2 < inTree_ && inTree_ > 64) buildTree();
        if (progress) progress(cut_);
    }
}

bool EarClipper::clip(std::span<glm::uvec3> triangles, const std::function<void(std::size_t)>& progress) {
    for (const Rule rule : {Rule::Strict, Rule::Lenient}) {
        // Where the outline crosses itself, clipping makes ears elsewhere too: try again as long as that
        // halves the polygon.
        for (std::size_t before = left_ + left_; left_ > 3 && left_ <= before / 2;) {
            before = left_;
            enqueueAll();
            cutEars(rule, triangles, progress);
        }
    }
    const bool isSimple =
        left_ == 3 && orientation(flat_[prev_[start_]], flat_[start_], flat_[next_[start_]]) >= 0.0;
    for (std::uint32_t corner = next_[start_]; left_ > 2; --left_, corner = next_[corner])
        triangles[cut_++] = {start_, corner, next_[corner]};
    return isSimple;
}

}  // namespace rayscope::scene
