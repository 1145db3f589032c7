#include "probe/traversal_costs.h"

#include <rayscope/probe.h>
#include <algorithm>

#include "bvh/traversal/traversal_counts.h"

namespace rayscope::probe {

ViewRays raysOfView(const trace::World& world, std::uint64_t seed, std::size_t motionGroup, int columns,
                    int rows) {
    ViewRays rays;
    columns = std::min(columns, world.width);
    rows = std::min(rows, world.height);
    const trace::Geometry& geometry = *world.motionGroups[motionGroup].geometry;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int x = (2 * column + 1) * world.width / (2 * columns),
                      y = (2 * row + 1) * world.height / (2 * rows);
            const RayTree tree = probeSample(world, seed, {x, y, 0});
            for (const RayNode& node : tree.nodes)
                rays.closest.push_back(geometry.inRestFrame(node.ray, tree.time));
            for (const ShadowRay& shadow : tree.shadowRays)
                if (shadow.visibility != Visibility::FacingAway)
                    rays.any.push_back(geometry.inRestFrame(shadow.ray, tree.time));
        }
    return rays;
}

TraversalCosts traversalCosts(const bvh::BinaryTree& tree, const AccelInput& input, const ViewRays& rays) {
    bvh::TraversalCounts counts;
    for (const Ray& ray : rays.closest) bvh::countTraversal(tree, input, ray, false, counts);
    for (const Ray& ray : rays.any) bvh::countTraversal(tree, input, ray, true, counts);
    const double count = static_cast<double>(std::max<std::size_t>(rays.count(), 1));
    return {static_cast<double>(counts.nodes + counts.leaves) / count,
            static_cast<double>(counts.primitives) / count};
}

}  // namespace rayscope::probe
