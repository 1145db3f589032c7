#pragma once
#include <future>
#include <memory>
#include <optional>

#include "bvh/statistics.h"
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
        std::shared_ptr<const Geometry> geometry;
        std::shared_ptr<const Accel> accel;         ///< whose tree it is, or whose rival
        std::shared_ptr<const BinaryTree> ownTree;  ///< of a rival
        BvhBuilder builder = BvhBuilder::SahBinned;
        TreeIndex index;
        TreeStatistics statistics;

        const BinaryTree& tree() const { return ownTree ? *ownTree : *accel->binaryTree(); }
        IndexedTree indexed() const { return {tree(), index}; }
    };

    BvhChoice shown;
    std::size_t body = 0;  ///< of the world

    /// Follows the world and what is shown. To be called in each frame in which any of it is seen.
    void update(const std::shared_ptr<const World>& world);
    /// The tree of the chosen body; null where there is none, or until it is indexed.
    const Inspected* inspected() const { return inspected_ ? &*inspected_ : nullptr; }
    /// The same primitives sorted by the other kind of builder; null until it is built, or if not wanted.
    const Inspected* rival() const;
    bool busy() const { return coming_.valid() || comingRival_.valid(); }
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
        shown.node = kNoNode;
    }
    /// Chooses the leaf that holds a primitive of the body.
    void selectLeafOf(std::uint32_t primitive);

  private:
    void keepInRange();

    std::optional<Inspected> inspected_, rival_;
    std::future<Inspected> coming_, comingRival_;
    std::stop_source stopRival_;
    int version_ = 0;
};

}  // namespace rayscope::viewer
