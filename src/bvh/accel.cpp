#include <rayscope/accel.h>

#include <stdexcept>

#include "base/check_argument.h"
#include "base/memory_budget.h"
#include "bvh/builders/build.h"
#include "bvh/builders/refit.h"
#include "bvh/isa.h"
#include "bvh/layout/packed_primitives.h"
#include "bvh/layout/primitive_refs.h"
#include "bvh/layout/statistics.h"
#include "bvh/layout/wide_tree.h"
#include "bvh/traversal/crossings.h"
#include "bvh/traversal/traverse.h"

namespace rayscope {

struct Accel::State {
    AccelInput input;
    bvh::BinaryTree tree;
    bvh::PackedPrimitives primitives;
    bvh::WideTree wide;
    bvh::kernel::WideTreeView view{};               ///< of `wide`, for every ray
    const bvh::kernel::Kernels* kernels = nullptr;  ///< null: queries traverse the binary tree
    AccelSummary summary;
    BuildSettings settings;
    double costAtBuild = 0.0;  ///< 0: never refitted

    void setWide(bvh::WideTree&& layout) {
        wide = std::move(layout);
        view = wide.view();
    }
    void crossings(const Ray& ray, bvh::kernel::CrossingSink sink) const {
        if (kernels)
            kernels->crossings(view, bvh::rayData(ray), sink);
        else
            bvh::crossings(tree, input, ray, sink);
    }
    double cost() const { return kernels ? bvh::sahCostOf(wide) : bvh::statisticsOf(tree).sahCost; }
};

namespace {

/// Memory that every builder needs per primitive; docs/bvh.md has the figures.
constexpr std::uint64_t kPeakBytes = 100;

template <class Enum>
void checkEnumerator(Enum value, Enum last, std::string_view name) {
    base::checkArgument(value >= Enum{} && value <= last, "{} is enumerator {}; expected 0 … {}", name,
                        static_cast<int>(value), static_cast<int>(last));
}

void checkEnumerators(const BuildSettings& settings) {
    checkEnumerator(settings.builder, BvhBuilder::SahReinsertion, "builder");
    checkEnumerator(settings.layout, BvhLayout::Wide, "layout");
    checkEnumerator(settings.isa, Isa::Avx512, "isa");
}

void checkSpans(std::size_t rays, std::size_t results, std::string_view name) {
    base::checkArgument(rays == results, "{}: {} elements for {} rays", name, results, rays);
}

}  // namespace

Accel::Accel() = default;
Accel::~Accel() = default;
Accel::Accel(Accel&&) noexcept = default;
Accel& Accel::operator=(Accel&&) noexcept = default;

Accel Accel::build(const AccelInput& input, const BuildSettings& settings) {
    Accel accel;
    accel.state_ = std::make_unique<State>();
    State& state = *accel.state_;
    state.input = input;
    state.settings = settings;
    state.settings.stop = {};
    checkEnumerators(settings);
    const bvh::kernel::Kernels& kernels = bvh::kernelsFor(settings.isa);
    bvh::checkPrimitiveCount(input);
    const std::size_t primitives = input.triangles.size() + input.spheres.size();
    base::requireMemory(kPeakBytes * primitives, "a smaller scene", "the BVH of {} primitives", primitives);
    state.tree = bvh::buildBinaryTree(input, settings);
    state.summary = {.binaryNodes = state.tree.nodes.size(),
                     .binaryLevels = state.tree.levels,
                     .droppedPrimitives = state.tree.droppedPrimitives};
    if (settings.layout == BvhLayout::Binary || state.tree.nodes.empty()) {
        state.primitives = bvh::PackedPrimitives(input, state.tree, settings.stop);
        return accel;
    }
    state.setWide(bvh::collapse(state.tree, input, settings.stop));
    state.summary.wideNodes = state.wide.nodes.size();
    state.summary.triangleBlocks = state.wide.blocks.size();
    state.kernels = &kernels;
    state.summary.isa = settings.isa == Isa::Auto ? bvh::bestIsa() : settings.isa;
    if (!settings.keepBinaryTree) state.tree = {};
    return accel;
}

Accel Accel::refit(const AccelInput& moved, std::stop_token stop) const {
    const AccelInput& before = input();
    if (moved.triangles.size() != before.triangles.size() || moved.spheres.size() != before.spheres.size())
        throw std::invalid_argument("refit needs as many triangles and spheres as the tree was built for");
    Accel accel;
    if (!state_) return accel;
    const auto rebuild = [&] {
        BuildSettings settings = state_->settings;
        settings.stop = stop;
        return build(moved, settings);
    };
    bvh::checkIndices(moved, stop);
    const std::uint32_t dropped = state_->summary.droppedPrimitives;
    if (dropped > 0 && bvh::countNonFinitePrimitives(moved, stop) != dropped) return rebuild();
    accel.state_ = std::make_unique<State>();
    State& state = *accel.state_;
    state.input = moved;
    state.settings = state_->settings;
    state.kernels = state_->kernels;
    state.summary = state_->summary;
    state.costAtBuild = state_->costAtBuild > 0.0 ? state_->costAtBuild : state_->cost();
    if (!state_->tree.nodes.empty()) {
        std::optional<bvh::BinaryTree> tree = bvh::refitted(state_->tree, moved, stop);
        if (!tree) return rebuild();
        state.tree = std::move(*tree);
    }
    if (state.kernels) {
        std::optional<bvh::WideTree> wide = bvh::refitted(state_->wide, moved, stop);
        if (!wide) return rebuild();
        state.setWide(std::move(*wide));
    } else {
        state.primitives = bvh::PackedPrimitives(moved, state.tree, stop);
    }
    if (state.costAtBuild > 0.0) state.summary.costGrowth = state.cost() / state.costAtBuild;
    return accel;
}

bool Accel::closestHit(const Ray& ray, Hit& hit) const {
    if (!state_) {
        hit = Hit{};
        return false;
    }
    if (state_->kernels) {
        const bool isHit = state_->kernels->closestHit(state_->view, bvh::rayData(ray), *bvh::hitData(&hit));
        if (!isHit) hit = Hit{};
        return isHit;
    }
    return bvh::traverse<bvh::QueryKind::Closest>(state_->tree, state_->primitives, ray, hit);
}

bool Accel::anyHit(const Ray& ray) const {
    if (state_ && state_->kernels) return state_->kernels->anyHit(state_->view, bvh::rayData(ray));
    Hit hit;
    return state_ && bvh::traverse<bvh::QueryKind::Any>(state_->tree, state_->primitives, ray, hit);
}

void Accel::closestHits(std::span<const Ray> rays, std::span<Hit> hits) const {
    checkSpans(rays.size(), hits.size(), "hits");
    if (state_ && state_->kernels) {
        state_->kernels->closestHits(state_->view, reinterpret_cast<const float*>(rays.data()),
                                     bvh::hitData(hits.data()), rays.size());
        return;
    }
    for (std::size_t i = 0; i < rays.size(); ++i) closestHit(rays[i], hits[i]);
}

void Accel::anyHits(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
    checkSpans(rays.size(), occluded.size(), "occluded");
    if (state_ && state_->kernels) {
        state_->kernels->anyHits(state_->view, reinterpret_cast<const float*>(rays.data()), occluded.data(),
                                 rays.size());
        return;
    }
    for (std::size_t i = 0; i < rays.size(); ++i) occluded[i] = anyHit(rays[i]);
}

void Accel::crossings(const Ray& ray, std::vector<Hit>& found) const {
    found.clear();
    if (state_) state_->crossings(ray, bvh::appendTo(found));
    bvh::sortCrossings(found);
}

std::size_t Accel::countCrossings(const Ray& ray) const {
    std::size_t count = 0;
    if (state_)
        state_->crossings(
            ray, {[](void* to, const bvh::kernel::HitData&) { ++*static_cast<std::size_t*>(to); }, &count});
    return count;
}

bool Accel::contains(const glm::vec3& point) const {
    // Any direction gives the same parity; this one is parallel to no axis and few edges.
    return countCrossings({point, {0.267f, 0.802f, 0.535f}}) % 2 != 0;
}

const bvh::BinaryTree* Accel::binaryTree() const {
    return state_ && !state_->tree.nodes.empty() ? &state_->tree : nullptr;
}

const bvh::WideTree* Accel::wideTree() const { return state_ && state_->kernels ? &state_->wide : nullptr; }

const AccelInput& Accel::input() const {
    static const AccelInput kNothing;
    return state_ ? state_->input : kNothing;
}

const AccelSummary& Accel::summary() const {
    static const AccelSummary kEmpty;
    return state_ ? state_->summary : kEmpty;
}

std::size_t Accel::bytes() const {
    if (!state_) return 0;
    return sizeof(State) + state_->tree.nodes.capacity() * sizeof(bvh::BinaryNode) +
           state_->tree.primitives.capacity() * sizeof(std::uint32_t) + state_->primitives.bytes() +
           state_->wide.bytes();
}

}  // namespace rayscope
