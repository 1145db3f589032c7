#pragma once
#include <rayscope/accel.h>

#include "bvh/binary_tree.h"
#include "bvh/intersect/ray_query.h"

namespace rayscope::bvh {

/// Copies of the corners of all primitives in the order of the leaves, so that a leaf takes one or two cache
/// lines. A sphere has its center in the first corner and its radius in the x of the second.
class PackedPrimitives {
  public:
    PackedPrimitives() = default;
    PackedPrimitives(const AccelInput& input, const BinaryTree& tree, const std::stop_token& stop);

    std::uint32_t number(std::uint32_t slot) const { return order_[slot]; }

    bool hits(const RayQuery& query, std::uint32_t slot, float bound, Hit& found) const {
        const Record& record = records_[slot];
        if (hasSpheres_ && order_[slot] >= firstSphere_)
            return query.hits(Sphere{record.corner[0], record.corner[1].x}, bound, found);
        return query.hits(record.corner[0], record.corner[1], record.corner[2], bound, found);
    }

    std::size_t bytes() const { return records_.capacity() * sizeof(Record); }

  private:
    struct Record {
        glm::vec3 corner[3];
    };
    base::BigVector<Record> records_;
    const std::uint32_t* order_ = nullptr;  ///< BinaryTree::primitives, which must outlive this
    std::uint32_t firstSphere_ = 0;
    bool hasSpheres_ = false;
};

}  // namespace rayscope::bvh
