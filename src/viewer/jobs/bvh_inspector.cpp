#include "viewer/jobs/bvh_inspector.h"

#include <algorithm>
#include <chrono>

#include "bvh/builders/build.h"
#include "viewer/model/viewer_seed.h"

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
    const auto start = std::chrono::steady_clock::now();
    referenceTree.ownedTree = std::make_shared<const bvh::BinaryTree>(
        bvh::buildBinaryTree(referenceTree.geometry->input, settings));
    referenceTree.buildSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return inspect(std::move(referenceTree));
}

/// Keeps a tree and its geometry alive, without index and statistics.
struct TreeHandle {
    std::shared_ptr<const trace::Geometry> geometry;
    std::shared_ptr<const Accel> accel;
    std::shared_ptr<const bvh::BinaryTree> ownedTree;

    explicit TreeHandle(const InspectedTree& inspected)
        : geometry(inspected.geometry), accel(inspected.accel), ownedTree(inspected.ownedTree) {}
    const bvh::BinaryTree& tree() const { return ownedTree ? *ownedTree : *accel->binaryTree(); }
    const AccelInput& input() const { return geometry->input; }
};

/// Over the rays of a grid of pixels of the view.
BvhInspector::Costs countCosts(const trace::World& world, std::size_t motionGroup, const TreeHandle& own,
                               const TreeHandle& referenceTree) {
    constexpr int kColumns = 32, kRows = 24;
    const probe::ViewRays rays = probe::raysOfView(world, kViewerSeed, motionGroup, kColumns, kRows);
    return {rays.count(), probe::traversalCosts(own.tree(), own.input(), rays),
            probe::traversalCosts(referenceTree.tree(), referenceTree.input(), rays)};
}

}  // namespace

void BvhInspector::takeResults() {
    if (auto indexed = indexing_.poll()) {
        inspected_ = std::move(indexed);
        ++version_;
        clampSelection();
    }
    if (auto built = referenceBuild_.poll()) {
        referenceTree_ = std::move(built);
        ++version_;
    }
    if (auto counted = counting_.poll()) costs_ = std::move(counted);
    if (auto computed = splitting_.poll()) curve_ = std::move(computed);
}

void BvhInspector::update(const std::shared_ptr<const trace::World>& world) {
    takeResults();
    if (!world) return;
    motionGroup = std::min(motionGroup, world->motionGroups.empty() ? 0 : world->motionGroups.size() - 1);
    const bool hasTree = !world->motionGroups.empty() && world->settings.bvh &&
                         world->motionGroups[motionGroup].accel &&
                         world->motionGroups[motionGroup].accel->binaryTree() != nullptr;
    if (!hasTree) {
        if (inspected_) ++version_;
        indexing_.discard();
        indexingAccel_.reset();
        inspected_.reset();
        referenceTree_.reset();
        return;
    }
    const trace::MotionGroup& wanted = world->motionGroups[motionGroup];
    if (indexingAccel_ != wanted.accel) {
        InspectedTree fresh;
        fresh.geometry = wanted.geometry;
        fresh.accel = indexingAccel_ = wanted.accel;
        fresh.builder = world->settings.bvhBuilder;
        fresh.buildSeconds = world->buildReport.seconds;
        referenceTree_.reset();
        referenceBuild_.discard();
        indexing_.start([fresh](const std::stop_token&, JobProgress&) { return inspect(fresh); });
    }
    if (!inspected_ || inspected_->accel != wanted.accel) return;
    updateReferenceTree(world);
    updateCosts(world);
}

BvhInspector::BuilderSettings BvhInspector::builderSettingsOf(const Settings& settings) {
    return {settings.bvhBuilder, settings.bvhBins, settings.bvhLeafSize, settings.bvhMaxLevel};
}

BvhInspector::BuilderSettings BvhInspector::referenceBuild(const Settings& settings) const {
    if (compareWith) return *compareWith;
    BuilderSettings builderSettings = builderSettingsOf(settings);
    builderSettings.builder =
        builderSettings.builder == BvhBuilder::Median ? BvhBuilder::SahBinned : BvhBuilder::Median;
    return builderSettings;
}

void BvhInspector::updateReferenceTree(const std::shared_ptr<const trace::World>& world) {
    const BuilderSettings wanted = referenceBuild(world->settings);
    const bool isRequested =
        wanted == referenceSettings_ && (referenceTree() != nullptr || referenceBuild_.busy());
    if (!shown.showReference || isRequested) return;
    referenceTree_.reset();
    referenceSettings_ = wanted;
    InspectedTree fresh;
    fresh.geometry = inspected_->geometry;
    fresh.accel = inspected_->accel;
    referenceBuild_.start([fresh, wanted](const std::stop_token& stop, JobProgress&) {
        return buildReferenceTree(fresh, {.builder = wanted.builder,
                                          .bins = wanted.bins,
                                          .maxLevel = wanted.maxLevel,
                                          .leafSize = wanted.leafSize,
                                          .stop = stop});
    });
}

void BvhInspector::updateCosts(const std::shared_ptr<const trace::World>& world) {
    const bool isRequested = costsWorld_.lock() == world && costsVersion_ == version_;
    if (!shown.showReference || referenceTree() == nullptr || isRequested) return;
    if (costsVersion_ != version_) costs_.reset();
    costsWorld_ = world;
    costsVersion_ = version_;
    counting_.start(
        [world, group = motionGroup, own = TreeHandle(*inspected_), reference = TreeHandle(*referenceTree_)](
            const std::stop_token&, JobProgress&) { return countCosts(*world, group, own, reference); });
}

const probe::SplitCurve* BvhInspector::curve(int bins) {
    const std::uint32_t node = shown.node == bvh::kNoNode ? 0 : shown.node;
    const SplitKey wanted{inspected_->accel.get(), node, bins};
    if (wanted != curveKey_) {
        curveKey_ = wanted;
        curve_.reset();
        splitting_.start([tree = TreeHandle(*inspected_), node, bins](const std::stop_token&, JobProgress&) {
            return probe::splitCurve(tree.tree(), tree.input(), node, bins);
        });
    }
    return curve_ ? &*curve_ : nullptr;
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
        const auto primitives = probe::primitivesOfLeaf(tree, leaf);
        if (std::find(primitives.begin(), primitives.end(), primitive) == primitives.end()) continue;
        select(leaf);
        shown.leaf = true;
    }
}

}  // namespace rayscope::viewer
