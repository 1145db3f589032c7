#include "fuzz/targets.h"

#include <algorithm>

namespace rayscope::test {

namespace {

// The formats of images are told apart by their content; each has a corpus of its own.
constexpr FuzzTarget kTargets[]{
    {"png", fuzzImage},
    {"jpeg", fuzzImage},
    {"bmp", fuzzImage},
    {"tga", fuzzImage},
    {"hdr", fuzzImage},
    {"pfm", fuzzImage},
    {"pnm", fuzzImage},
    {"exr", fuzzImage},
    {"obj", fuzzObj},
    {"mtl", fuzzMtl},
    {"ply", fuzzPly},
    {"stl", fuzzStl},
    {"gltf", fuzzGltf},
    {"scene", fuzzScene},
    {"settings", fuzzSettings},
    {"recent", fuzzRecentFiles},
    {"text", fuzzPrintableText},
#ifndef RAYSCOPE_FUZZ_READERS_ONLY
    {"options", fuzzOptions},
    {"rays", fuzzRays},
    {"films", fuzzFilms},
#endif
};

}  // namespace

std::span<const FuzzTarget> fuzzTargets() { return kTargets; }

const FuzzTarget* findFuzzTarget(std::string_view name) {
    const auto found = std::ranges::find(kTargets, name, &FuzzTarget::name);
    return found == std::end(kTargets) ? nullptr : &*found;
}

}  // namespace rayscope::test
