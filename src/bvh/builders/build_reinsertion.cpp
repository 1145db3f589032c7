#include <tbb/blocked_range.h>
#include <tbb/concurrent_vector.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <utility>

#include "bvh/builders/builders.h"
#include "bvh/builders/leaf_plan.h"
#include "bvh/builders/reinsertion.h"
#include "bvh/stop_check.h"

namespace rayscope::bvh {
namespace {

/// On scanned meshes three rounds gain more than kMinRoundGain, on long thin triangles five.
constexpr int kMaxRounds = 8;
constexpr double kMinRoundGain = 0.002;  ///< of the cost, for another round

constexpr std::size_t kSearchesPerTask = 64;

using Reinsertions = tbb::concurrent_vector<Reinsertion>;

/// All reinsertions with a gain in the current tree, the highest first.
Reinsertions findReinsertions(const LinkedTree& tree, const std::stop_token& stop) {
    Reinsertions found;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, tree.size(), kSearchesPerTask), [&](const auto& block) {
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

/// Applies those that still have a gain, in order. Returns the saved area.
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

BinaryTree improveByReinsertion(const BinaryTree& source, const BuildSettings& settings, float scale) {
    LinkedTree tree(source, scale, settings.stop);
    const float costBefore = LeafPlan(tree, source, settings).cost();
    for (int round = 0; round < kMaxRounds; ++round) {
        const double gain = reinsert(tree, findReinsertions(tree, settings.stop), settings);
        if (gain < kMinRoundGain * static_cast<double>(costBefore)) break;
    }
    const LeafPlan plan(tree, source, settings);
    if (plan.cost() <= costBefore) return plan.make();
    // With less area of inner nodes there may be fewer leaves of several primitives, at a higher cost.
    const LinkedTree unchanged(source, scale, settings.stop);
    return LeafPlan(unchanged, source, settings).make();
}

}  // namespace rayscope::bvh
