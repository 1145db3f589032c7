#include <rayscope/diagnostics.h>
#include <rayscope/probe.h>

#include "base/check_argument.h"
#include "probe/ray_tree_recorder.h"
#include "trace/radiance_definition.h"

namespace rayscope {

namespace {

sampling::SampleStream streamOf(const trace::World& world, std::uint64_t seed, SampleId name) {
    return {world.settings.sampler, seed, name.x, name.y, name.index, world.settings.spp};
}

/// Per channel; 0 where the factor is 0.
RgbSum dividedBy(const RgbSum& value, const RgbSum& factor) {
    RgbSum quotient(0.0);
    for (int channel = 0; channel < 3; ++channel)
        if (factor[channel] > 0.0) quotient[channel] = value[channel] / factor[channel];
    return quotient;
}

}  // namespace

RayTree probeSample(const trace::World& world, std::uint64_t seed, SampleId name,
                    const std::stop_token& stop) {
    RayTree tree;
    tree.name = name;
    if (world.moves) tree.time = streamOf(world, seed, name).get1D(sampling::Dim::Time);
    probe::RayTreeRecorder recorder(tree, world);
    tree.radiance = trace::radiance(world, seed, name, recorder, stop).radiance;
    if (stop.stop_requested()) throw Stopped{};
    return tree;
}

std::vector<RgbSum> radianceAlong(const RayTree& tree) {
    std::vector<RgbSum> sums(tree.nodes.size(), RgbSum(0.0));
    // Parents come before their children.
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        const RayNode& node = tree.nodes[i];
        sums[i] += node.contribution;
        base::checkArgument(node.parent < static_cast<int>(i), "tree: nodes[{}] has parent {}", i,
                            node.parent);
        if (node.parent >= 0) sums[static_cast<std::size_t>(node.parent)] += sums[i];
        sums[i] = dividedBy(sums[i], node.throughput);
    }
    return sums;
}

RgbSum surfaceColor(const RayNode& node) {
    return dividedBy(node.contribution, node.throughput * (node.hit ? node.opacity : 1.0));
}

glm::dvec2 samplePosition(const trace::World& world, std::uint64_t seed, SampleId name) {
    return glm::dvec2(name.x, name.y) + glm::dvec2(streamOf(world, seed, name).get2D(sampling::Dim::Pixel));
}

}  // namespace rayscope
