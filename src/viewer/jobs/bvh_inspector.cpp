#include "viewer/jobs/bvh_inspector.h"

#include <algorithm>

#include "bvh/build/build.h"

namespace rayscope::viewer {

namespace {

using InspectedTree = BvhInspector::InspectedTree;

InspectedTree inspect(InspectedTree inspected) {
    inspected.index = probe::indexTree(inspected.tree());
    inspected.statistics = bvh::statisticsOf(inspected.tree());
    return inspected;
}

InspectedTree buildReferenceTree(InspectedTree referenceTree, BuildSettings settings) {
    referenceTree.builder = settings.builder;
    referenceTree.ownedTree = std::make_shared<const bvh::BinaryTree>(
        bvh::buildBinaryTree(referenceTree.geometry->input, settings));
    return inspect(std::move(referenceTree));
}

/// A tree without what is known about it, kept alive.
struct TreeHandle {
    std::shared_ptr<const trace::Geometry> geometry;
    std::shared_ptr<const Accel> accel;
    std::shared_ptr<const bvh::BinaryTree> ownedTree;

    explicit TreeHandle(const InspectedTree& whole)
        : geometry(whole.geometry), accel(whole.accel), ownedTree(whole.ownedTree) {}
    const bvh::BinaryTree& tree() const { return ownedTree ? *ownedTree : *accel->binaryTree(); }
    const AccelInput& input() const { return geometry->input; }
};

/// Over the rays of some hundred pixels of the view.
BvhInspector::Costs countCosts(std::shared_ptr<const trace::World> world, std::size_t motionGroup,
                               TreeHandle own, TreeHandle referenceTree) {
    constexpr int kColumns = 32, kRows = 24;
    constexpr std::uint64_t kSeed = 0;  // the window renders with this one
    const probe::ViewRays rays = probe::raysOfView(*world, kSeed, motionGroup, kColumns, kRows);
    return {rays.count(), probe::traversalCosts(own.tree(), own.input(), rays),
            probe::traversalCosts(referenceTree.tree(), referenceTree.input(), rays)};
}

template <class T>
bool isReady(const std::future<T>& future) {
    return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

BvhInspector::~BvhInspector() { stopReference_.request_stop(); }

void BvhInspector::update(const std::shared_ptr<const trace::World>& world) {
    if (isReady(pending_)) {
        inspected_ = pending_.get();
        ++version_;
        clampSelection();
    }
    if (!world) return;
    motionGroup = std::min(motionGroup, world->motionGroups.empty() ? 0 : world->motionGroups.size() - 1);
    const bool hasTree = !world->motionGroups.empty() && world->settings.bvh &&
                         world->motionGroups[motionGroup].accel &&
                         world->motionGroups[motionGroup].accel->binaryTree() != nullptr;
    if (!hasTree) {
        if (inspected_) ++version_;
        inspected_.reset();
        referenceTree_.reset();
        return;
    }
    const trace::MotionGroup& wanted = world->motionGroups[motionGroup];
    const bool isKnown = inspected_ && inspected_->accel == wanted.accel;
    if (!isKnown && !pending_.valid()) {
        InspectedTree fresh;
        fresh.geometry = wanted.geometry;
        fresh.accel = wanted.accel;
        fresh.builder = world->settings.bvhBuilder;
        referenceTree_.reset();
        stopReference_.request_stop();
        pending_ = std::async(std::launch::async, inspect, std::move(fresh));
    }
    if (isKnown) updateReferenceTree(world);
    if (isKnown) updateCosts(world);
}

BvhInspector::BuilderSettings BvhInspector::builderSettingsOf(const Settings& settings) {
    return {settings.bvhBuilder, settings.bvhBins, settings.bvhLeafSize, settings.bvhMaxLevel};
}

/// The heuristic's referenceTree is the median split, and the other way round.
BvhInspector::BuilderSettings BvhInspector::referenceBuild(const Settings& settings) const {
    if (compareWith) return *compareWith;
    BuilderSettings builderSettings = builderSettingsOf(settings);
    builderSettings.builder =
        builderSettings.builder == BvhBuilder::Median ? BvhBuilder::SahBinned : BvhBuilder::Median;
    return builderSettings;
}

void BvhInspector::updateReferenceTree(const std::shared_ptr<const trace::World>& world) {
    const BuilderSettings builderSettings = referenceBuild(world->settings);
    const bool isWanted = builderSettings == referenceBuild_;
    if (isReady(pendingReference_)) {
        try {
            referenceTree_ = pendingReference_.get();
            ++version_;
        } catch (const Stopped&) {
            // Another one is wanted by now.
        }
    }
    if (!shown.showReference || (referenceTree() != nullptr && isWanted)) return;
    if (pendingReference_.valid()) {
        if (!isWanted) stopReference_.request_stop();
        return;
    }
    referenceTree_.reset();
    referenceBuild_ = builderSettings;
    InspectedTree fresh;
    fresh.geometry = inspected_->geometry;
    fresh.accel = inspected_->accel;
    stopReference_ = std::stop_source{};
    pendingReference_ = std::async(std::launch::async, buildReferenceTree, std::move(fresh),
                                   BuildSettings{.builder = builderSettings.builder,
                                                 .bins = builderSettings.bins,
                                                 .maxLevel = builderSettings.maxLevel,
                                                 .leafSize = builderSettings.leafSize,
                                                 .stop = stopReference_.get_token()});
}

void BvhInspector::updateCosts(const std::shared_ptr<const trace::World>& world) {
    const bool isKnown = costsWorld_.lock() == world && costsVersion_ == version_;
    if (isReady(pendingCosts_)) {
        const Costs counted = pendingCosts_.get();
        if (costsVersion_ == version_) costs_ = counted;
    }
    if (!shown.showReference || referenceTree() == nullptr || isKnown || pendingCosts_.valid()) return;
    if (costsVersion_ != version_) costs_.reset();
    costsWorld_ = world;
    costsVersion_ = version_;
    pendingCosts_ = std::async(std::launch::async, countCosts, world, motionGroup, TreeHandle(*inspected_),
                               TreeHandle(*referenceTree_));
}

const probe::SplitCurve* BvhInspector::curve(int bins) {
    if (isReady(pendingCurve_)) {
        curve_ = pendingCurve_.get();
        curveKey_ = pendingCurveKey_;
    }
    const std::uint32_t node = shown.node == bvh::kNoNode ? 0 : shown.node;
    const std::tuple wanted{inspected_->accel.get(), node, bins};
    if (wanted != curveKey_ && !pendingCurve_.valid()) {
        pendingCurveKey_ = wanted;
        pendingCurve_ = std::async(std::launch::async, [tree = TreeHandle(*inspected_), node, bins] {
            return probe::splitCurve(tree.tree(), tree.input(), node, bins);
        });
    }
    return wanted == curveKey_ ? &curve_ : nullptr;
}

const BvhInspector::InspectedTree* BvhInspector::referenceTree() const {
    return referenceTree_ && inspected_ && referenceTree_->accel == inspected_->accel ? &*referenceTree_
                                                                                      : nullptr;
}

void BvhInspector::clampSelection() {
    const int leaves = static_cast<int>(inspected_->index.leaves.size());
    shown.leafNumber = std::clamp(shown.leafNumber, 0, std::max(0, leaves - 1));
    shown.level = std::clamp(shown.level, 0, std::max(0, inspected_->tree().levels - 1));
    if (shown.node != bvh::kNoNode && shown.node >= inspected_->tree().nodes.size())
        shown.node = bvh::kNoNode;
}

void BvhInspector::stepLeaf(int by) {
    if (!inspected_ || !shown.leaf) {
        shown.leaf = true;
        return;
    }
    const int leaves = static_cast<int>(inspected_->index.leaves.size());
    shown.leafNumber = (shown.leafNumber + by + leaves) % leaves;
}

void BvhInspector::stepLevel(int by) {
    if (!inspected_ || !(shown.levels || shown.showReference)) {
        shown.levels = true;
        return;
    }
    shown.level = std::clamp(shown.level + by, 0, inspected_->tree().levels - 1);
}

void BvhInspector::select(std::uint32_t node) {
    shown.node = node;
    if (!inspected_ || node == bvh::kNoNode || !inspected_->tree().nodes[node].isLeaf()) return;
    shown.leafNumber = static_cast<int>(inspected_->index.leafNumber(node));
}

void BvhInspector::selectLeafOf(std::uint32_t primitive) {
    if (!inspected_) return;
    const bvh::BinaryTree& tree = inspected_->tree();
    for (const std::uint32_t leaf : inspected_->index.leaves) {
        const auto held = probe::primitivesOfLeaf(tree, leaf);
        if (std::find(held.begin(), held.end(), primitive) == held.end()) continue;
        select(leaf);
        shown.leaf = true;
    }
}

}  // namespace rayscope::viewer
