#pragma once
#include <future>
#include <memory>
#include <optional>
#include <tuple>

#include "bvh/layout/statistics.h"
#include "probe/split_curve.h"
#include "probe/traversal_costs.h"
#include "trace/world.h"
#include "viewer/overlay/bvh_overlay.h"

namespace rayscope::viewer {

/// Looks into the hierarchy that rays traversal. What takes long (indexing a large tree, building a
/// referenceTree) is done beside the window.
class BvhInspector {
  public:
    ~BvhInspector();

    /// A tree and its geometry, kept alive.
    struct InspectedTree {
        std::shared_ptr<const trace::Geometry> geometry;
        std::shared_ptr<const Accel> accel;                ///< whose tree it is, or whose referenceTree
        std::shared_ptr<const bvh::BinaryTree> ownedTree;  ///< of a referenceTree
        BvhBuilder builder = BvhBuilder::SahBinned;
        probe::TreeIndex index;
        bvh::TreeStatistics statistics;

        const bvh::BinaryTree& tree() const { return ownedTree ? *ownedTree : *accel->binaryTree(); }
        IndexedTree indexed() const { return {tree(), index}; }
    };

    /// How another tree over the same primitives is built, to compare with.
    struct BuilderSettings {
        BvhBuilder builder = BvhBuilder::SahBinned;
        int bins = 32, leafSize = 4, maxLevel = bvh::kMaxTreeLevel;
        bool operator==(const BuilderSettings&) const = default;
    };
    static BuilderSettings builderSettingsOf(const Settings& settings);
    /// The referenceTree that is wanted; without one, it differs from the tree by the other kind of builder.
    std::optional<BuilderSettings> compareWith;
    BuilderSettings referenceBuild(const Settings& settings) const;

    BvhOverlayOptions shown;
    std::size_t motionGroup = 0;  ///< of the world

    /// Follows the world and what is shown. To be called in each frame in which any of it is seen.
    void update(const std::shared_ptr<const trace::World>& world);
    /// The tree of the chosen motionGroup; null where there is none, or until it is indexed.
    const InspectedTree* inspected() const { return inspected_ ? &*inspected_ : nullptr; }
    /// The same primitives sorted otherwise; null until it is built, or if not wanted.
    const InspectedTree* referenceTree() const;
    /// What the rays of the current view cost with the tree and with its referenceTree; null until counted.
    struct Costs {
        std::size_t rays = 0;
        probe::TraversalCosts own, referenceTree;
    };
    const Costs* costs() const { return referenceTree() != nullptr && costs_ ? &*costs_ : nullptr; }
    /// What splits of the selected node, or of the root, would cost; null until known.
    const probe::SplitCurve* curve(int bins);
    bool busy() const {
        return pending_.valid() || pendingReference_.valid() || pendingCosts_.valid() ||
               pendingCurve_.valid();
    }
    /// Grows when inspected() or referenceTree() become others.
    int version() const { return version_; }

    /// Shows leaf or level, or, if one is shown, the next one.
    void stepLeaf(int by);
    void stepLevel(int by);
    /// Chooses a node and what belongs to it.
    void select(std::uint32_t node);
    /// Chooses no node and no leaf.
    void clearSelection() {
        shown.leaf = false;
        shown.node = bvh::kNoNode;
    }
    /// Chooses the leaf that holds a primitive of the motionGroup.
    void selectLeafOf(std::uint32_t primitive);

  private:
    void clampSelection();
    void updateReferenceTree(const std::shared_ptr<const trace::World>& world);
    void updateCosts(const std::shared_ptr<const trace::World>& world);

    std::optional<InspectedTree> inspected_, referenceTree_;
    BuilderSettings referenceBuild_;  ///< of the referenceTree, or of the one that is being built
    std::optional<Costs> costs_;
    std::future<Costs> pendingCosts_;
    std::weak_ptr<const trace::World> costsWorld_;  ///< whose view costs_ is of, or will be
    int costsVersion_ = -1;
    probe::SplitCurve curve_;
    std::future<probe::SplitCurve> pendingCurve_;
    std::tuple<const Accel*, std::uint32_t, int> curveKey_{nullptr, bvh::kNoNode, 0}, pendingCurveKey_;
    std::future<InspectedTree> pending_, pendingReference_;
    std::stop_source stopReference_;
    int version_ = 0;
};

}  // namespace rayscope::viewer
