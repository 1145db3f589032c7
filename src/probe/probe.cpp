#include <rayscope/probe.h>

#include "probe/ray_tree_recorder.h"
#include "trace/radiance.inl"

namespace rayscope {

RayTree probe(const World& world, std::uint64_t seed, SampleName name) {
    RayTree tree;
    tree.name = name;
    if (world.moves) {
        const Settings& settings = world.settings;
        tree.time =
            SampleStream(settings.sampler, seed, name.x, name.y, name.index, settings.spp).get1D(Dim::Time);
    }
    RayTreeRecorder recorder(tree);
    tree.radiance = radiance(world, seed, name, recorder).radiance;
    return tree;
}

}  // namespace rayscope
