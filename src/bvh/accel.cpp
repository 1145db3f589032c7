#include <rayscope/accel.h>

#include <cassert>

#include "bvh/build.h"
#include "bvh/packed_primitives.h"
#include "bvh/traverse.h"

namespace rayscope {

struct Accel::State {
    AccelInput input;
    BinaryTree tree;
    PackedPrimitives primitives;
};

Accel::Accel() = default;
Accel::~Accel() = default;
Accel::Accel(Accel&&) noexcept = default;
Accel& Accel::operator=(Accel&&) noexcept = default;

Accel Accel::build(const AccelInput& input, const BuildSettings& settings) {
    Accel accel;
    accel.state_ = std::make_unique<State>();
    State& state = *accel.state_;
    state.input = input;
    state.tree = buildBinaryTree(input, settings);
    state.primitives = PackedPrimitives(input, state.tree, settings.stop);
    return accel;
}

bool Accel::closestHit(const Ray& ray, Hit& hit) const {
    if (!state_) {
        hit = Hit{};
        return false;
    }
    NullTraversalObserver nobody;
    return walkToClosestHit(state_->tree, state_->primitives, ray, hit, nobody);
}

bool Accel::anyHit(const Ray& ray) const {
    return state_ && walkToAnyHit(state_->tree, state_->primitives, ray);
}

void Accel::closestHits(std::span<const Ray> rays, std::span<Hit> hits) const {
    assert(rays.size() == hits.size());
    for (std::size_t i = 0; i < rays.size(); ++i) closestHit(rays[i], hits[i]);
}

void Accel::anyHits(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
    assert(rays.size() == occluded.size());
    for (std::size_t i = 0; i < rays.size(); ++i) occluded[i] = anyHit(rays[i]);
}

const BinaryTree* Accel::binaryTree() const {
    return state_ && !state_->tree.nodes.empty() ? &state_->tree : nullptr;
}

const AccelInput& Accel::input() const {
    static const AccelInput kNothing;
    return state_ ? state_->input : kNothing;
}

std::size_t Accel::bytes() const {
    if (!state_) return 0;
    return sizeof(State) + state_->tree.nodes.capacity() * sizeof(BinaryNode) +
           state_->tree.primitives.capacity() * sizeof(std::uint32_t) + state_->primitives.bytes();
}

}  // namespace rayscope
