#include "bvh/builders/tree_skeleton.h"

#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "bvh/stop_check.h"

namespace rayscope::bvh {
namespace {

constexpr std::size_t kChunkSize = 512;

BinaryNode makeNode(const Bounds4& box, std::size_t first, std::size_t count) {
    return {{box.lower[0], box.lower[1], box.lower[2]},
            static_cast<std::uint32_t>(first),
            {box.upper[0], box.upper[1], box.upper[2]},
            static_cast<std::uint32_t>(count)};
}

}  // namespace

TreeSkeleton::TreeSkeleton(std::size_t primitives, const BuildSettings& settings)
    : count_(primitives),
      settings_(settings),
      chunks_(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency())),
      allocated_(1),
      // A thread allocates a chunk only when its last one is full.
      nodes_(2 * primitives + kChunkSize * chunks_.size()),
      primitives_(primitives) {}

std::size_t TreeSkeleton::allocatePair() {
    // Negative before the first task of the thread, when there are no others.
    const int thread = std::max(0, tbb::this_task_arena::current_thread_index());
    NodeChunk& chunk = chunks_[static_cast<std::size_t>(thread)];
    if (chunk.next == chunk.end) {
        chunk.next = allocated_.fetch_add(kChunkSize);
        chunk.end = chunk.next + kChunkSize;
    }
    return std::exchange(chunk.next, chunk.next + 2);
}

std::pair<Subtree, Subtree> TreeSkeleton::split(const Subtree& tree, const Bounds4& box, std::size_t middle) {
    const std::size_t pair = allocatePair();
    nodes_[tree.node] = makeNode(box, pair, 0);
    return {{tree.begin, middle, pair, tree.level + 1}, {middle, tree.end, pair + 1, tree.level + 1}};
}

void TreeSkeleton::makeLeaf(const Subtree& tree, const Bounds4& box) {
    nodes_[tree.node] = makeNode(box, tree.begin, tree.size());
}

bool TreeSkeleton::mustSplitAtMedian(const Subtree& tree) {
    return static_cast<int>(std::bit_width(tree.size())) >= kMaxTreeLevel - tree.level;
}

/// Copies the nodes of a skeleton in depth-first order. The upper levels are processed in parallel, which
/// needs the sizes of their subtrees.
class TreeSkeleton::Compaction {
  public:
    explicit Compaction(const TreeSkeleton& from)
        : from_(from),
          sharedLevels_(from.count_ > kParallelSize ? kParallelLevels : 0),
          sizes_(std::size_t{2} << sharedLevels_) {
        if (from_.count_ == 0) return;
        tree_.nodes.resize(sizeOf({0, 0, 1}));
        tree_.levels = place({0, 0, 1}, 0, 1);
    }
    BinaryTree& result() { return tree_; }

  private:
    static constexpr int kParallelLevels = 6;
    static constexpr std::size_t kParallelSize = 4096;

    /// A node of the skeleton; `path` is 1 for the root, 2 p and 2 p + 1 for the children of p.
    struct Root {
        std::uint32_t node;
        int level;
        std::size_t path;

        Root child(std::uint32_t at, unsigned which) const {
            return {at + which, level + 1, 2 * path + which};
        }
    };

    bool isShared(const Root& root) const { return root.level < sharedLevels_; }

    /// The number of nodes below and including a root.
    std::size_t sizeOf(const Root& root) {
        const BinaryNode& node = from_.nodes_[root.node];
        std::size_t size = 1;
        if (!node.isLeaf() && isShared(root)) {
            std::size_t left = 0, right = 0;
            tbb::parallel_invoke([&] { left = sizeOf(root.child(node.first, 0)); },
                                 [&] { right = sizeOf(root.child(node.first, 1)); });
            size += left + right;
        } else if (!node.isLeaf()) {
            size = countFrom(root.node);
        }
        if (root.path < sizes_.size()) sizes_[root.path] = size;
        return size;
    }

    std::size_t countFrom(std::uint32_t root) const {
        std::vector<std::uint32_t> stack{root};
        std::size_t count = 0;
        while (!stack.empty()) {
            if (count++ % kStopInterval == 0) throwIfStopped(from_.settings_.stop);
            const BinaryNode& node = from_.nodes_[stack.back()];
            stack.pop_back();
            if (!node.isLeaf()) stack.insert(stack.end(), {node.first + 1, node.first});
        }
        return count;
    }

    /// Writes a root to `at` and its subtree from `below` on. Returns the number of levels down to its
    /// leaves.
    int place(const Root& root, std::size_t at, std::size_t below) {
        const BinaryNode& node = tree_.nodes[at] = from_.nodes_[root.node];
        if (node.isLeaf()) return root.level + 1;
        if (!isShared(root)) return placeAlone(at, below, root.level);
        const Root left = root.child(node.first, 0), right = root.child(node.first, 1);
        tree_.nodes[at].first = static_cast<std::uint32_t>(below);
        const std::size_t belowRight = below + 2 + sizes_[left.path] - 1;
        int levels[2];
        tbb::parallel_invoke([&] { levels[0] = place(left, below, below + 2); },
                             [&] { levels[1] = place(right, below + 1, belowRight); });
        return std::max(levels[0], levels[1]);
    }

    int placeAlone(std::size_t root, std::size_t below, int rootLevel) {
        struct StackEntry {
            std::size_t node;
            int level;
        };
        std::vector<StackEntry> stack{{root, rootLevel}};
        int levels = 0;
        std::size_t placed = 0;
        while (!stack.empty()) {
            const auto [number, level] = stack.back();
            stack.pop_back();
            levels = std::max(levels, level + 1);
            BinaryNode& node = tree_.nodes[number];
            if (node.isLeaf()) continue;
            if (placed++ % kStopInterval == 0) throwIfStopped(from_.settings_.stop);
            const std::uint32_t children = std::exchange(node.first, static_cast<std::uint32_t>(below));
            tree_.nodes[below] = from_.nodes_[children];
            tree_.nodes[below + 1] = from_.nodes_[children + 1];
            stack.push_back({below + 1, level + 1});
            stack.push_back({below, level + 1});
            below += 2;
        }
        return levels;
    }

    const TreeSkeleton& from_;
    const int sharedLevels_;
    std::vector<std::size_t> sizes_;  ///< by path
    BinaryTree tree_;
};

BinaryTree TreeSkeleton::compact() {
    BinaryTree tree = std::move(Compaction(*this).result());
    tree.primitives = std::move(primitives_);
    nodes_ = base::BigVector<BinaryNode>();
    return tree;
}

}  // namespace rayscope::bvh
