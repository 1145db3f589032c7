#include "bvh/layout/packed_primitives.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "bvh/stop_check.h"

namespace rayscope::bvh {

PackedPrimitives::PackedPrimitives(const AccelInput& input, const BinaryTree& tree,
                                   const std::stop_token& stop)
    : records_(tree.primitives.size()),
      order_(tree.primitives.data()),
      firstSphere_(static_cast<std::uint32_t>(input.triangles.size())),
      hasSpheres_(!input.spheres.empty()) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, records_.size(), 8192), [&](const auto& block) {
        throwIfStopped(stop);
        for (std::size_t slot = block.begin(); slot < block.end(); ++slot) {
            const std::uint32_t primitive = order_[slot];
            if (primitive >= firstSphere_) {
                const Sphere& sphere = input.spheres[primitive - firstSphere_];
                records_[slot] = {{sphere.center, glm::vec3(sphere.radius), glm::vec3(0.0f)}};
            } else {
                const glm::uvec3& corner = input.triangles[primitive];
                records_[slot] = {
                    {input.vertices[corner.x], input.vertices[corner.y], input.vertices[corner.z]}};
            }
        }
    });
}

}  // namespace rayscope::bvh
