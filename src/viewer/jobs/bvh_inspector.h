#pragma once
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "bvh/layout/statistics.h"
#include "probe/split_curve.h"
#include "probe/traversal_costs.h"
#include "trace/world.h"
#include "viewer/jobs/background_job.h"
#include "viewer/model/indexed_tree.h"
#include "viewer/model/overlay_options.h"

namespace rayscope::viewer {

/// Statistics, node selection and comparison of the BVH that rays traverse. Indexing, building a reference
/// tree and counting costs are background jobs.
class BvhInspector {
  public:
    /// A tree and its geometry, kept alive.
    struct InspectedTree {
        std::shared_ptr<const trace::Geometry> geometry;
        std::shared_ptr<const Accel> accel;                ///< holds the tree, or the one it is compared with
        std::shared_ptr<const bvh::BinaryTree> ownedTree;  ///< the tree, if it is a reference tree
        BvhBuilder builder = BvhBuilder::SahBinned;
        double buildSeconds = 0.0;  ///< of all BVHs of the world, or of the reference tree
        probe::TreeIndex index;
        bvh::TreeStatistics statistics;

        const bvh::BinaryTree& tree() const { return ownedTree ? *ownedTree : *accel->binaryTree(); }
        IndexedTree indexed() const { return {tree(), index}; }
    };

    /// How a reference tree is built.
    struct BuilderSettings {
        BvhBuilder builder = BvhBuilder::SahBinned;
        int bins = 32, leafSize = 4, maxLevel = bvh::kMaxTreeLevel;
        bool operator==(const BuilderSettings&) const = default;
    };
    static BuilderSettings builderSettingsOf(const Settings& settings);
    /// How to build the reference tree; by default like the tree, but by median split instead of SAH or vice
    /// versa.
    std::optional<BuilderSettings> compareWith;
    BuilderSettings referenceBuild(const Settings& settings) const;

    BvhOverlayOptions shown;
    std::size_t motionGroup = 0;  ///< of the world

    /// Inspects the BVH of `world` as far as `shown` needs it. To be called in each frame in which panel or
    /// overlay are visible.
    void update(const std::shared_ptr<const trace::World>& world);
    /// The tree of the selected motion group; null if it has none, or until it is indexed.
    const InspectedTree* inspected() const { return inspected_ ? &*inspected_ : nullptr; }
    /// Another tree of the same primitives; null until it is built, or if not wanted.
    const InspectedTree* referenceTree() const;
    /// Traversal costs of the rays of the current view in both trees; null until counted.
    struct Costs {
        std::size_t rays = 0;
        probe::TraversalCosts own, referenceTree;
    };
    const Costs* costs() const { return referenceTree() != nullptr && costs_ ? &*costs_ : nullptr; }
    /// SAH costs of the split planes of the selected node, or of the root; null until computed.
    const probe::SplitCurve* curve(int bins);
    bool busy() const {
        return indexing_.busy() || referenceBuild_.busy() || counting_.busy() || splitting_.busy();
    }
    /// Increases whenever inspected() or referenceTree() change.
    int version() const { return version_; }

    /// Shows leaf or level or, if one is shown, moves on to another.
    void stepLeaf(int by);
    void stepLevel(int by);
    /// Selects a node and, if it is a leaf, that leaf.
    void select(std::uint32_t node);
    /// Whether another node was selected since the last call: a list of nodes then scrolls to it.
    bool takeSelectionChange() { return std::exchange(listedNode_, shown.node) != shown.node; }
    /// Selects no node and no leaf.
    void clearSelection() {
        shown.leaf = false;
        shown.node = bvh::kNoNode;
    }
    /// Selects the leaf that holds a primitive of the motion group.
    void selectLeafOf(std::uint32_t primitive);

  private:
    void takeResults();
    void clampSelection();
    void updateReferenceTree(const std::shared_ptr<const trace::World>& world);
    void updateCosts(const std::shared_ptr<const trace::World>& world);

    /// A node of a tree and the number of bins.
    using SplitKey = std::tuple<const Accel*, std::uint32_t, int>;

    std::optional<InspectedTree> inspected_, referenceTree_;
    BackgroundJob<InspectedTree> indexing_, referenceBuild_;
    std::shared_ptr<const Accel> indexingAccel_;  ///< of the latest indexing job
    BuilderSettings referenceSettings_;           ///< of the latest reference build

    BackgroundJob<Costs> counting_;
    std::optional<Costs> costs_;
    std::weak_ptr<const trace::World> costsWorld_;  ///< of the latest counting job
    int costsVersion_ = -1;                         ///< of the trees of that job

    BackgroundJob<probe::SplitCurve> splitting_;
    std::optional<probe::SplitCurve> curve_;
    SplitKey curveKey_{nullptr, bvh::kNoNode, 0};  ///< of the latest splitting job
    std::uint32_t listedNode_ = bvh::kNoNode;      ///< see takeSelectionChange()
    int version_ = 0;
};

}  // namespace rayscope::viewer
