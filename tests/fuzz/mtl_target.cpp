#include <cmath>

#include "fuzz/memory_file.h"
#include "scene/mesh_files/obj/mtl_reader.h"

namespace rayscope::test {

/// Any bytes give materials with values in their ranges, or InputError.
bool fuzzMtl(FuzzInput input) {
    static const MemoryFile file("fuzzed.mtl");
    Diagnostics notes;
    const LoadControl control;
    scene::TextureCache textures(notes, control);
    try {
        for (const Material& m : scene::readMtl(file.write(input), {textures, notes, control})) {
            const auto isFraction = [](float value) { return value >= 0.0f && value <= 1.0f; };
            for (int c = 0; c < 3; ++c)
                require(isFraction(m.kd[c]) && isFraction(m.ks[c]), "kd and ks are fractions");
            require(isFraction(m.opacity), "the opacity is a fraction");
            require(m.shininess >= 0.0f && std::isfinite(m.shininess), "the shininess is at least 0");
        }
    } catch (const InputError&) {
    }
    return true;
}

}  // namespace rayscope::test
