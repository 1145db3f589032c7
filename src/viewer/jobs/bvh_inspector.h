#pragma once
#include <future>
#include <memory>
#include <optional>
#include <tuple>

#include "bvh/layout/statistics.h"
#include "probe/search_costs.h"
#include "probe/split_curve.h"
#include "trace/world.h"
#include "viewer/overlay/bvh_overlay.h"

namespace rayscope::viewer {

/// Looks into the hierarchy that rays search. What takes long (indexing a large tree, building a rival) is
/// done beside the window.
class BvhInspector {
  public:
    ~BvhInspector();

    /// A tree and its geometry, kept alive.
    struct Inspected {
        std::shared_ptr<const trace::Geometry> geometry;
        std::shared_ptr<const Accel> accel;              ///< whose tree it is, or whose rival
        std::shared_ptr<const bvh::BinaryTree> ownTree;  ///< of a rival
        BvhBuilder builder = BvhBuilder::SahBinned;
        probe::TreeIndex index;
        bvh::TreeStatistics statistics;

        const bvh::BinaryTree& tree() const { return ownTree ? *ownTree : *accel->binaryTree(); }
        IndexedTree indexed() const { return {tree(), index}; }
    };

    /// How another tree over the same primitives is built, to compare with.
    struct Recipe {
        BvhBuilder builder = BvhBuilder::SahBinned;
        int bins = 32, leafSize = 4, maxLevel = bvh::kMaxTreeLevel;
        bool operator==(const Recipe&) const = default;
    };
    static Recipe recipeOf(const Settings& settings);
    /// The rival that is wanted; without one, it differs from the tree by the other kind of builder.
    std::optional<Recipe> wantedRival;
    Recipe rivalRecipe(const Settings& settings) const;

    BvhChoice shown;
    std::size_t body = 0;  ///< of the world

    /// Follows the world and what is shown. To be called in each frame in which any of it is seen.
    void update(const std::shared_ptr<const trace::World>& world);
    /// The tree of the chosen body; null where there is none, or until it is indexed.
    const Inspected* inspected() const { return inspected_ ? &*inspected_ : nullptr; }
    /// The same primitives sorted otherwise; null until it is built, or if not wanted.
    const Inspected* rival() const;
    /// What the rays of the present view cost with the tree and with its rival; null until counted.
    struct Costs {
        std::size_t rays = 0;
        probe::SearchCosts own, rival;
    };
    const Costs* costs() const { return rival() != nullptr && costs_ ? &*costs_ : nullptr; }
    /// What splits of the selected node, or of the root, would cost; null until known.
    const probe::SplitCurve* curve(int bins);
    bool busy() const {
        return coming_.valid() || comingRival_.valid() || comingCosts_.valid() || comingCurve_.valid();
    }
    /// Grows when inspected() or rival() become others.
    int version() const { return version_; }

    /// Shows leaf or level, or, if one is shown, the next one.
    void stepLeaf(int by);
    void stepLevel(int by);
    /// Chooses a node and what belongs to it.
    void select(std::uint32_t node);
    /// Chooses no node and no leaf.
    void letGo() {
        shown.leaf = false;
        shown.node = bvh::kNoNode;
    }
    /// Chooses the leaf that holds a primitive of the body.
    void selectLeafOf(std::uint32_t primitive);

  private:
    void keepInRange();
    void updateRival(const std::shared_ptr<const trace::World>& world);
    void updateCosts(const std::shared_ptr<const trace::World>& world);

    std::optional<Inspected> inspected_, rival_;
    Recipe rivalRecipe_;  ///< of the rival, or of the one that is being built
    std::optional<Costs> costs_;
    std::future<Costs> comingCosts_;
    std::weak_ptr<const trace::World> countedWorld_;  ///< whose view costs_ is of, or will be
    int countedVersion_ = -1;
    probe::SplitCurve curve_;
    std::future<probe::SplitCurve> comingCurve_;
    std::tuple<const Accel*, std::uint32_t, int> curveOf_{nullptr, bvh::kNoNode, 0}, comingCurveOf_;
    std::future<Inspected> coming_, comingRival_;
    std::stop_source stopRival_;
    int version_ = 0;
};

}  // namespace rayscope::viewer
