#include "probe/split_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bvh/bounds.h"
#include "bvh/intersect/ray_query.h"
#include "bvh/layout/statistics.h"

namespace rayscope::probe {

namespace {

constexpr double kNoCost = std::numeric_limits<double>::quiet_NaN();

struct Box {
    glm::dvec3 lower{std::numeric_limits<double>::infinity()};
    glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

    void extend(const Box& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
    double halfArea() const {
        const glm::dvec3 size = upper - lower;
        return size.x < 0.0 ? 0.0 : bvh::halfAreaOf(size);
    }
};

/// A primitive's box and its centroid, rounded as the builder rounds it.
struct Item {
    Box box;
    glm::vec3 centroid;
};

Item itemOf(const AccelInput& input, std::uint32_t primitive) {
    bvh::PrimitiveBox planes;
    if (primitive >= input.triangles.size()) {
        planes = bvh::boxOf(input.spheres[primitive - input.triangles.size()]);
    } else {
        const glm::uvec3& corner = input.triangles[primitive];
        planes = bvh::boxOf(input.vertices[corner.x], input.vertices[corner.y], input.vertices[corner.z]);
    }
    const float* p = planes.planes;
    const glm::vec3 lower(p[0], p[1], p[2]), upper(p[4], p[5], p[6]);
    return {{glm::dvec3(lower), glm::dvec3(upper)}, lower * 0.5f + upper * 0.5f};
}

/// Does not store the primitives: a root may have millions.
template <class Visit>
void forEachBelow(const bvh::BinaryTree& tree, const AccelInput& input, std::uint32_t node,
                  const Visit& visit) {
    std::vector<std::uint32_t> open{node};
    while (!open.empty()) {
        const bvh::BinaryNode& n = tree.nodes[open.back()];
        open.pop_back();
        if (!n.isLeaf()) open.insert(open.end(), {n.first, n.first + 1});
        for (std::uint32_t slot = n.first; n.isLeaf() && slot < n.first + n.count; ++slot)
            visit(itemOf(input, tree.primitives[slot]));
    }
}

/// All primitives below a node.
struct Range {
    Box box;
    glm::vec3 lowest{std::numeric_limits<float>::infinity()};  ///< of centroids
    glm::vec3 highest{-std::numeric_limits<float>::infinity()};
    std::uint32_t count = 0;

    void add(const Item& item) {
        box.extend(item.box);
        lowest = glm::min(lowest, item.centroid);
        highest = glm::max(highest, item.centroid);
        ++count;
    }
};

struct Bin {
    Box box;
    std::uint32_t count = 0;
};

/// Equally wide bins along one axis; an axis along which all centroids are (nearly) equal has none.
struct AxisBins {
    int axis;
    float lowest, perUnit;
    std::vector<Bin> bins;

    AxisBins(const Range& whole, int along, int count)
        : axis(along),
          lowest(whole.lowest[along]),
          perUnit(static_cast<float>(count) / (whole.highest[along] - lowest)) {
        if (perUnit > 0.0f && std::isfinite(perUnit)) bins.resize(static_cast<std::size_t>(count));
    }
    void add(const Item& item) {
        if (bins.empty()) return;
        const auto index = static_cast<std::size_t>((item.centroid[axis] - lowest) * perUnit);
        Bin& bin = bins[std::min(index, bins.size() - 1)];
        bin.box.extend(item.box);
        ++bin.count;
    }
};

/// Sweep over the borders between bins.
std::vector<SplitCurve::Plane> planesOf(const AxisBins& along, std::uint32_t all, double area) {
    const std::vector<Bin>& bins = along.bins;
    std::vector<double> rightArea(bins.size());
    Box right, left;
    for (std::size_t i = bins.size(); i-- > 1;) {
        right.extend(bins[i].box);
        rightArea[i] = right.halfArea();
    }
    std::vector<SplitCurve::Plane> planes;
    std::uint32_t before = 0;
    for (std::size_t i = 1; i < bins.size(); ++i) {
        left.extend(bins[i - 1].box);
        before += bins[i - 1].count;
        const double children = left.halfArea() * before + rightArea[i] * (all - before);
        const bool isSplit = before > 0 && before < all && area > 0.0;
        const double position =
            static_cast<double>(along.lowest) + static_cast<double>(i) / static_cast<double>(along.perUnit);
        planes.push_back({position,
                          isSplit ? bvh::kTraversalCost + bvh::kIntersectionCost * children / area : kNoCost,
                          before});
    }
    return planes;
}

}  // namespace

SplitCurve splitCurve(const bvh::BinaryTree& tree, const AccelInput& input, std::uint32_t node, int bins) {
    Range whole;
    forEachBelow(tree, input, node, [&](const Item& item) { whole.add(item); });
    AxisBins along[] = {{whole, 0, bins}, {whole, 1, bins}, {whole, 2, bins}};
    forEachBelow(tree, input, node, [&](const Item& item) {
        for (AxisBins& axis : along) axis.add(item);
    });
    const double area = whole.box.halfArea();
    SplitCurve curve;
    curve.primitives = whole.count;
    curve.leafCost = bvh::kIntersectionCost * static_cast<double>(whole.count);
    curve.actualCost = kNoCost;
    for (const AxisBins& axis : along)
        curve.axes[static_cast<std::size_t>(axis.axis)] = planesOf(axis, whole.count, area);
    if (tree.nodes[node].isLeaf() || !(area > 0.0)) return curve;
    double children = 0.0;
    for (const std::uint32_t child : {tree.nodes[node].first, tree.nodes[node].first + 1}) {
        Range side;
        forEachBelow(tree, input, child, [&](const Item& item) { side.add(item); });
        children += side.box.halfArea() * side.count;
    }
    curve.actualCost = bvh::kTraversalCost + bvh::kIntersectionCost * children / area;
    return curve;
}

}  // namespace rayscope::probe
