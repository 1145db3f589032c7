#include "bvh/traversal/crossings.h"

#include <algorithm>
#include <tuple>

#include "bvh/intersect/ray_query.h"
#include "bvh/kernel/sphere.h"
#include "bvh/traversal/traverse.h"

namespace rayscope::bvh {

namespace {

void crossPrimitive(const RayQuery& query, const AccelInput& input, std::uint32_t primitive,
                    kernel::CrossingSink sink) {
    kernel::HitData found[2];
    int count;
    if (primitive >= input.triangles.size()) {
        const Sphere& sphere = input.spheres[primitive - input.triangles.size()];
        count = kernel::crossSphere(rayData(query.ray), sphereData(sphere), query.ray.tMax, found);
    } else {
        Hit hit;
        count = IndexedPrimitives::hitsPrimitive(query, input, primitive, query.ray.tMax, hit);
        found[0] = *hitData(&hit);
    }
    for (int i = 0; i < count; ++i) {
        found[i].primitive = primitive;
        sink.add(sink.to, found[i]);
    }
}

}  // namespace

void crossings(const BinaryTree& tree, const AccelInput& input, const Ray& ray, kernel::CrossingSink sink) {
    if (tree.nodes.empty() || !RayQuery::isTraceable(ray)) return;
    const RayQuery query(ray);
    std::uint32_t stack[kMaxTreeLevel + 1] = {0};
    for (int stackSize = 1; stackSize > 0;) {
        const BinaryNode& node = tree.nodes[stack[--stackSize]];
        float entry;
        if (!intersectBox(planes(node), query.box, query.box.tMax, entry)) continue;
        if (!node.isLeaf()) {
            stack[stackSize++] = node.first;
            stack[stackSize++] = node.first + 1;
            continue;
        }
        for (std::uint32_t slot = node.first; slot < node.first + node.count; ++slot)
            crossPrimitive(query, input, tree.primitives[slot], sink);
    }
}

std::vector<Hit> crossingsBruteForce(const AccelInput& input, const Ray& ray) {
    std::vector<Hit> found;
    if (!RayQuery::isTraceable(ray)) return found;
    const RayQuery query(ray);
    const auto count = static_cast<std::uint32_t>(input.triangles.size() + input.spheres.size());
    for (std::uint32_t primitive = 0; primitive < count; ++primitive)
        crossPrimitive(query, input, primitive, appendTo(found));
    sortCrossings(found);
    return found;
}

void sortCrossings(std::vector<Hit>& found) {
    std::ranges::sort(found, {}, [](const Hit& hit) { return std::tuple(hit.t, hit.primitive); });
}

}  // namespace rayscope::bvh
