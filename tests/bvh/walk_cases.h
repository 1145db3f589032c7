#pragma once
#include <vector>

#include "bvh/isa.h"
#include "bvh/meshes.h"

namespace rayscope::test {

/// What queries may walk: the binary tree, and the wide one with every kernel that this machine can run.
struct WalkCase {
    BvhLayout layout;
    Isa isa;
    const char* name;
    bool keepsBinaryTree = true;
};
inline std::vector<WalkCase> walkCases() {
    std::vector<WalkCase> cases{{BvhLayout::Binary, Isa::Auto, "binary"},
                                {BvhLayout::Wide, Isa::Auto, "wide, alone", false}};
    for (const WalkCase& wide : {WalkCase{BvhLayout::Wide, Isa::Scalar, "wide, scalar"},
                                 {BvhLayout::Wide, Isa::Sse2, "wide, SSE2"},
                                 {BvhLayout::Wide, Isa::Avx2, "wide, AVX2"},
                                 {BvhLayout::Wide, Isa::Avx512, "wide, AVX-512"}})
        if (bvh::isAvailable(wide.isa)) cases.push_back(wide);
    return cases;
}

inline Accel build(const Geometry& scene, BuildSettings settings, const WalkCase& walk) {
    settings.layout = walk.layout;
    settings.isa = walk.isa;
    settings.keepBinaryTree = walk.keepsBinaryTree;
    return Accel::build(scene.input(), settings);
}

}  // namespace rayscope::test
