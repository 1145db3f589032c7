#include "viewer/jobs/bvh_inspector.h"

#include <algorithm>

#include "bvh/build/build.h"

namespace rayscope::viewer {

namespace {

using Inspected = BvhInspector::Inspected;

Inspected inspect(Inspected inspected) {
    inspected.index = probe::indexTree(inspected.tree());
    inspected.statistics = bvh::statisticsOf(inspected.tree());
    return inspected;
}

Inspected buildRival(Inspected rival, BuildSettings settings) {
    rival.builder = settings.builder;
    rival.ownTree =
        std::make_shared<const bvh::BinaryTree>(bvh::buildBinaryTree(rival.geometry->input, settings));
    return inspect(std::move(rival));
}

/// A tree without what is known about it, kept alive.
struct BareTree {
    std::shared_ptr<const trace::Geometry> geometry;
    std::shared_ptr<const Accel> accel;
    std::shared_ptr<const bvh::BinaryTree> ownTree;

    explicit BareTree(const Inspected& whole)
        : geometry(whole.geometry), accel(whole.accel), ownTree(whole.ownTree) {}
    const bvh::BinaryTree& tree() const { return ownTree ? *ownTree : *accel->binaryTree(); }
    const AccelInput& input() const { return geometry->input; }
};

/// Over the rays of some hundred pixels of the view.
BvhInspector::Costs countCosts(std::shared_ptr<const trace::World> world, std::size_t body, BareTree own,
                               BareTree rival) {
    constexpr int kColumns = 32, kRows = 24;
    constexpr std::uint64_t kSeed = 0;  // the window renders with this one
    const probe::ViewRays rays = probe::raysOfView(*world, kSeed, body, kColumns, kRows);
    return {rays.count(), probe::searchCosts(own.tree(), own.input(), rays),
            probe::searchCosts(rival.tree(), rival.input(), rays)};
}

template <class T>
bool isReady(const std::future<T>& future) {
    return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

BvhInspector::~BvhInspector() { stopRival_.request_stop(); }

void BvhInspector::update(const std::shared_ptr<const trace::World>& world) {
    if (isReady(coming_)) {
        inspected_ = coming_.get();
        ++version_;
        keepInRange();
    }
    if (!world) return;
    body = std::min(body, world->bodies.empty() ? 0 : world->bodies.size() - 1);
    const bool hasTree = !world->bodies.empty() && world->settings.bvh && world->bodies[body].accel &&
                         world->bodies[body].accel->binaryTree() != nullptr;
    if (!hasTree) {
        if (inspected_) ++version_;
        inspected_.reset();
        rival_.reset();
        return;
    }
    const trace::Body& wanted = world->bodies[body];
    const bool isKnown = inspected_ && inspected_->accel == wanted.accel;
    if (!isKnown && !coming_.valid()) {
        Inspected fresh;
        fresh.geometry = wanted.geometry;
        fresh.accel = wanted.accel;
        fresh.builder = world->settings.bvhBuilder;
        rival_.reset();
        stopRival_.request_stop();
        coming_ = std::async(std::launch::async, inspect, std::move(fresh));
    }
    if (isKnown) updateRival(world);
    if (isKnown) updateCosts(world);
}

BvhInspector::Recipe BvhInspector::recipeOf(const Settings& settings) {
    return {settings.bvhBuilder, settings.bvhBins, settings.bvhLeafSize, settings.bvhMaxLevel};
}

/// The heuristic's rival is the median split, and the other way round.
BvhInspector::Recipe BvhInspector::rivalRecipe(const Settings& settings) const {
    if (wantedRival) return *wantedRival;
    Recipe recipe = recipeOf(settings);
    recipe.builder = recipe.builder == BvhBuilder::Median ? BvhBuilder::SahBinned : BvhBuilder::Median;
    return recipe;
}

void BvhInspector::updateRival(const std::shared_ptr<const trace::World>& world) {
    const Recipe recipe = rivalRecipe(world->settings);
    const bool isWanted = recipe == rivalRecipe_;
    if (isReady(comingRival_)) {
        try {
            rival_ = comingRival_.get();
            ++version_;
        } catch (const Stopped&) {
            // Another one is wanted by now.
        }
    }
    if (!shown.savings || (rival() != nullptr && isWanted)) return;
    if (comingRival_.valid()) {
        if (!isWanted) stopRival_.request_stop();
        return;
    }
    rival_.reset();
    rivalRecipe_ = recipe;
    Inspected fresh;
    fresh.geometry = inspected_->geometry;
    fresh.accel = inspected_->accel;
    stopRival_ = std::stop_source{};
    comingRival_ = std::async(std::launch::async, buildRival, std::move(fresh),
                              BuildSettings{.builder = recipe.builder,
                                            .bins = recipe.bins,
                                            .maxLevel = recipe.maxLevel,
                                            .leafSize = recipe.leafSize,
                                            .stop = stopRival_.get_token()});
}

void BvhInspector::updateCosts(const std::shared_ptr<const trace::World>& world) {
    const bool isKnown = countedWorld_.lock() == world && countedVersion_ == version_;
    if (isReady(comingCosts_)) {
        const Costs counted = comingCosts_.get();
        if (countedVersion_ == version_) costs_ = counted;
    }
    if (!shown.savings || rival() == nullptr || isKnown || comingCosts_.valid()) return;
    if (countedVersion_ != version_) costs_.reset();
    countedWorld_ = world;
    countedVersion_ = version_;
    comingCosts_ =
        std::async(std::launch::async, countCosts, world, body, BareTree(*inspected_), BareTree(*rival_));
}

const probe::SplitCurve* BvhInspector::curve(int bins) {
    if (isReady(comingCurve_)) {
        curve_ = comingCurve_.get();
        curveOf_ = comingCurveOf_;
    }
    const std::uint32_t node = shown.node == bvh::kNoNode ? 0 : shown.node;
    const std::tuple wanted{inspected_->accel.get(), node, bins};
    if (wanted != curveOf_ && !comingCurve_.valid()) {
        comingCurveOf_ = wanted;
        comingCurve_ = std::async(std::launch::async, [tree = BareTree(*inspected_), node, bins] {
            return probe::splitCurve(tree.tree(), tree.input(), node, bins);
        });
    }
    return wanted == curveOf_ ? &curve_ : nullptr;
}

const BvhInspector::Inspected* BvhInspector::rival() const {
    return rival_ && inspected_ && rival_->accel == inspected_->accel ? &*rival_ : nullptr;
}

void BvhInspector::keepInRange() {
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
    if (!inspected_ || !(shown.levels || shown.savings)) {
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
