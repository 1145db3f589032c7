#pragma once
#include <vector>

#include "bvh/isa.h"
#include "bvh/meshes.h"

namespace rayscope::test {

/// What queries can traverse: the binary tree, and the wide one with every kernel that this machine supports.
struct TraversalCase {
    BvhLayout layout;
    Isa isa;
    const char* name;
    bool keepsBinaryTree = true;
};
inline std::vector<TraversalCase> traversalCases() {
    std::vector<TraversalCase> cases{{BvhLayout::Binary, Isa::Auto, "binary"},
                                     {BvhLayout::Wide, Isa::Auto, "wide, alone", false}};
    for (const TraversalCase& wide : {TraversalCase{BvhLayout::Wide, Isa::Scalar, "wide, scalar"},
                                      {BvhLayout::Wide, Isa::Sse2, "wide, SSE2"},
                                      {BvhLayout::Wide, Isa::Avx2, "wide, AVX2"},
                                      {BvhLayout::Wide, Isa::Avx512, "wide, AVX-512"}})
        if (bvh::isAvailable(wide.isa)) cases.push_back(wide);
    return cases;
}

inline Accel build(const TestGeometry& scene, BuildSettings settings, const TraversalCase& traversalCase) {
    settings.layout = traversalCase.layout;
    settings.isa = traversalCase.isa;
    settings.keepBinaryTree = traversalCase.keepsBinaryTree;
    return Accel::build(scene.input(), settings);
}

}  // namespace rayscope::test
