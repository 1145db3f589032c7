#include "scene/mesh_files/gltf/scene_graph.h"

#include <fmt/format.h>

namespace rayscope::scene {

namespace {

enum class Visit : std::uint8_t { Not, Open, Done };

struct Step {
    std::uint32_t node = 0;
    glm::dmat4 toScene{1.0};  ///< of the parent
    bool leaves = false;      ///< all children have been visited
};

void place(const GltfDocument& document, std::uint32_t index, const glm::dmat4& toScene,
           GltfPlacements& placements, Oddities& oddities) {
    const GltfNode& node = document.nodes[index];
    placements.toScene[index] = toScene;
    // Skins replace the transform of their node.
    if (node.mesh && !node.skin && glm::dmat3(toScene) == glm::dmat3(0.0))
        oddities.add(Severity::Note, "meshes that are scaled to zero; left out");
    else if (node.mesh)
        placements.meshes.push_back({*node.mesh, index, toScene});
    if (node.camera) placements.cameras.push_back({*node.camera, index, toScene});
    if (node.light) placements.lights.push_back({*node.light, index, toScene});
}

}  // namespace

GltfPlacements placementsOf(const GltfDocument& document, const std::string& path, Oddities& oddities) {
    GltfPlacements placements;
    placements.toScene.resize(document.nodes.size(), glm::dmat4(1.0));
    std::vector<Visit> visits(document.nodes.size(), Visit::Not);
    // A stack of its own, because the nesting of a file has no limit.
    std::vector<Step> stack;
    for (auto root = document.roots.rbegin(); root != document.roots.rend(); ++root) stack.push_back({*root});
    while (!stack.empty()) {
        const Step step = stack.back();
        stack.pop_back();
        Visit& visit = visits[step.node];
        if (step.leaves) {
            visit = Visit::Done;
            continue;
        }
        if (visit == Visit::Open)
            throw InputError(fmt::format("nodes[{}] is its own ancestor", step.node), {path});
        if (visit == Visit::Done) {
            oddities.add(Severity::Warning, "nodes with several parents; only the first one counts");
            continue;
        }
        visit = Visit::Open;
        const GltfNode& node = document.nodes[step.node];
        const glm::dmat4 toScene = step.toScene * node.matrix;
        place(document, step.node, toScene, placements, oddities);
        stack.push_back({step.node, glm::dmat4(1.0), true});
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
            stack.push_back({*child, toScene});
    }
    return placements;
}

}  // namespace rayscope::scene
