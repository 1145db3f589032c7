#include <tbb/blocked_range.h>
#include <tbb/concurrent_vector.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <utility>

#include "bvh/build/builders.h"
#include "bvh/build/leaf_plan.h"
#include "bvh/build/reinsertion.h"
#include "bvh/stop_check.h"

namespace rayscope::bvh {
namespace {

/// On the dragons the third round is the last that saves more than kMinRelativeGain; needles take five.
constexpr int kMaxRounds = 8;
constexpr double kMinRelativeGain = 0.002;  ///< of the cost, for another round

constexpr std::size_t kGrain = 64;
constexpr std::size_t kStopInterval = 1024;

using Reinsertions = tbb::concurrent_vector<Reinsertion>;

/// All nodes that would stand better elsewhere as the tree is now, the most valuable first.
Reinsertions findReinsertions(const LinkedTree& tree, const std::stop_token& stop) {
    Reinsertions found;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tree.size(), kGrain), [&](const auto& block) {
        throwIfStopped(stop);
        for (std::size_t node = block.begin(); node < block.end(); ++node) {
            const Reinsertion best = bestReinsertion(tree, static_cast<std::uint32_t>(node));
            if (best.target != kNoNode) found.push_back(best);
        }
    });
    tbb::parallel_sort(found.begin(), found.end(), [&](const Reinsertion& a, const Reinsertion& b) {
        throwIfStopped(stop);
        return a.gain > b.gain || (a.gain == b.gain && a.node < b.node);
    });
    return found;
}

/// One after another, as far as they still are worth it. Returns the saved area.
double reinsert(LinkedTree& tree, const Reinsertions& moves, const BuildSettings& settings) {
    double gain = 0.0;
    std::size_t done = 0;
    for (const Reinsertion& move : moves) {
        if (done++ % kStopInterval == 0) throwIfStopped(settings.stop);
        gain += tree.moveIfBetter(move.node, move.target, settings.maxLevel);
    }
    return gain;
}

}  // namespace

BinaryTree improveByReinsertion(BinaryTree source, const BuildSettings& settings, float scale) {
    LinkedTree tree(source, scale, settings.stop);
    const float costBefore = LeafPlan(tree, source, settings).cost();
    for (int round = 0; round < kMaxRounds; ++round) {
        const double gain = reinsert(tree, findReinsertions(tree, settings.stop), settings);
        if (gain < kMinRelativeGain * static_cast<double>(costBefore)) break;
    }
    const LeafPlan plan(tree, source, settings);
    if (plan.cost() <= costBefore) return plan.make();
    // Less area of inner nodes may come with fewer leaves of several primitives.
    const LinkedTree unchanged(source, scale, settings.stop);
    return LeafPlan(unchanged, source, settings).make();
}

}  // namespace rayscope::bvh
