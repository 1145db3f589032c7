#include "viewer/overlay/bvh_overlay.h"

#include <cmath>
#include <numbers>

#include "viewer/overlay/palette.h"

namespace rayscope::viewer {

namespace {

OverlayBox boxOf(const bvh::BinaryNode& node, glm::vec4 color, LineStyle style, float width) {
    return {node.lower, node.upper, color, style, width};
}

void appendCircle(OverlayLines& lines, glm::vec3 center, glm::vec3 a, glm::vec3 b, glm::vec4 color,
                  float width) {
    constexpr int kPieces = 32;
    const auto point = [&](int i) {
        const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / kPieces;
        return center + std::cos(angle) * a + std::sin(angle) * b;
    };
    for (int i = 0; i < kPieces; ++i)
        lines.push_back({point(i), point(i + 1), color, LineStyle::Solid, width});
}

bool hasLeaf(const IndexedTree& own, const BvhOverlayOptions& options) {
    return options.leaf && static_cast<std::size_t>(options.leafNumber) < own.index.leaves.size();
}

std::uint32_t leafNode(const IndexedTree& own, const BvhOverlayOptions& options) {
    return own.index.leaves[static_cast<std::size_t>(options.leafNumber)];
}

}  // namespace

OverlayBoxes levelBoxes(const IndexedTree& own, const IndexedTree* referenceTree,
                        const BvhOverlayOptions& options) {
    OverlayBoxes boxes;
    if (options.showReference && referenceTree != nullptr)
        for (const std::uint32_t node : probe::nodesAtLevel(referenceTree->tree, referenceTree->index,
                                                            options.level, options.leavesAbove))
            boxes.push_back(
                boxOf(referenceTree->tree.nodes[node], palette::kReferenceBox, LineStyle::Solid, 2.5f));
    if (options.levels || options.showReference)
        for (const std::uint32_t node :
             probe::nodesAtLevel(own.tree, own.index, options.level, options.leavesAbove))
            boxes.push_back(boxOf(own.tree.nodes[node], palette::kLevelBox, LineStyle::Solid, 1.2f));
    return boxes;
}

OverlayBoxes nodeBoxes(const bvh::BinaryTree& tree, std::uint32_t number) {
    if (number >= tree.nodes.size()) return {};
    const bvh::BinaryNode& node = tree.nodes[number];
    OverlayBoxes boxes;
    if (!node.isLeaf())
        for (const std::uint32_t child : {node.first, node.first + 1})
            boxes.push_back(boxOf(tree.nodes[child], palette::kChildBox, LineStyle::Dashed, 1.5f));
    boxes.push_back(boxOf(node, palette::kSelected, LineStyle::Solid, 3.0f));
    return boxes;
}

OverlayLines primitiveLines(const AccelInput& input, std::span<const std::uint32_t> primitives,
                            glm::vec4 color, float width) {
    OverlayLines lines;
    for (const std::uint32_t primitive : primitives) {
        if (primitive >= input.triangles.size()) {
            const Sphere& sphere = input.spheres[primitive - input.triangles.size()];
            const glm::vec3 x(sphere.radius, 0, 0), y(0, sphere.radius, 0), z(0, 0, sphere.radius);
            appendCircle(lines, sphere.center, x, y, color, width);
            appendCircle(lines, sphere.center, y, z, color, width);
            appendCircle(lines, sphere.center, z, x, color, width);
            continue;
        }
        const glm::uvec3& corner = input.triangles[primitive];
        for (int i = 0; i < 3; ++i)
            lines.push_back({input.vertices[corner[i]], input.vertices[corner[(i + 1) % 3]], color,
                             LineStyle::Solid, width});
    }
    return lines;
}

OverlayBoxes leafBoxes(const IndexedTree& own, const BvhOverlayOptions& options) {
    if (!hasLeaf(own, options)) return {};
    return {boxOf(own.tree.nodes[leafNode(own, options)], palette::kLeaf, LineStyle::Solid, 3.0f)};
}

OverlayLines leafLines(const IndexedTree& own, const AccelInput& input, const BvhOverlayOptions& options) {
    if (!hasLeaf(own, options)) return {};
    return primitiveLines(input, probe::primitivesOfLeaf(own.tree, leafNode(own, options)),
                          palette::kLeafPrimitive, 3.0f);
}

}  // namespace rayscope::viewer
