#include "viewer/bvh_inspector.h"

#include <algorithm>

#include "bvh/build.h"

namespace rayscope::viewer {

namespace {

using Inspected = BvhInspector::Inspected;

Inspected inspect(Inspected inspected) {
    inspected.index = indexTree(inspected.tree());
    inspected.statistics = statisticsOf(inspected.tree());
    return inspected;
}

/// The heuristic's rival is the median split, and the other way round.
Inspected buildRival(Inspected rival, BuildSettings settings) {
    rival.builder = settings.builder =
        settings.builder == BvhBuilder::Median ? BvhBuilder::SahBinned : BvhBuilder::Median;
    rival.ownTree = std::make_shared<const BinaryTree>(buildBinaryTree(rival.geometry->input, settings));
    return inspect(std::move(rival));
}

template <class T>
bool isReady(const std::future<T>& future) {
    return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

BvhInspector::~BvhInspector() { stopRival_.request_stop(); }

void BvhInspector::update(const std::shared_ptr<const World>& world) {
    if (isReady(coming_)) {
        inspected_ = coming_.get();
        ++version_;
        keepInRange();
    }
    if (isReady(comingRival_)) {
        try {
            rival_ = comingRival_.get();
            ++version_;
        } catch (const Stopped&) {
            // Another one is wanted by now.
        }
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
    const Body& wanted = world->bodies[body];
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
    if (shown.savings && isKnown && rival() == nullptr && !comingRival_.valid()) {
        const Settings& s = world->settings;
        Inspected fresh;
        fresh.geometry = wanted.geometry;
        fresh.accel = wanted.accel;
        stopRival_ = std::stop_source{};
        comingRival_ = std::async(std::launch::async, buildRival, std::move(fresh),
                                  BuildSettings{.builder = s.bvhBuilder,
                                                .bins = s.bvhBins,
                                                .maxLevel = s.bvhMaxLevel,
                                                .leafSize = s.bvhLeafSize,
                                                .stop = stopRival_.get_token()});
    }
}

const BvhInspector::Inspected* BvhInspector::rival() const {
    return rival_ && inspected_ && rival_->accel == inspected_->accel ? &*rival_ : nullptr;
}

void BvhInspector::keepInRange() {
    const int leaves = static_cast<int>(inspected_->index.leaves.size());
    shown.leafNumber = std::clamp(shown.leafNumber, 0, std::max(0, leaves - 1));
    shown.level = std::clamp(shown.level, 0, std::max(0, inspected_->tree().levels - 1));
    if (shown.node != kNoNode && shown.node >= inspected_->tree().nodes.size()) shown.node = kNoNode;
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
    if (!inspected_ || node == kNoNode || !inspected_->tree().nodes[node].isLeaf()) return;
    shown.leafNumber = static_cast<int>(inspected_->index.leafNumber(node));
}

void BvhInspector::selectLeafOf(std::uint32_t primitive) {
    if (!inspected_) return;
    const BinaryTree& tree = inspected_->tree();
    for (const std::uint32_t leaf : inspected_->index.leaves) {
        const auto held = primitivesOfLeaf(tree, leaf);
        if (std::find(held.begin(), held.end(), primitive) == held.end()) continue;
        select(leaf);
        shown.leaf = true;
    }
}

}  // namespace rayscope::viewer
