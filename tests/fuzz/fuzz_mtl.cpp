#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "fuzz/memory_file.h"
#include "scene/mesh_files/obj/mtl_reader.h"

/// Any bytes give materials with values in their ranges, or InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const rayscope::test::MemoryFile file("fuzzed.mtl");
    rayscope::Diagnostics notes;
    const rayscope::LoadControl control;
    rayscope::scene::TextureCache textures(notes, control);
    try {
        for (const rayscope::Material& m :
             rayscope::scene::readMtl(file.write(data, size), {textures, notes, control})) {
            const auto isFraction = [](float value) { return value >= 0.0f && value <= 1.0f; };
            for (int c = 0; c < 3; ++c)
                if (!isFraction(m.kd[c]) || !isFraction(m.ks[c])) std::abort();
            if (!isFraction(m.opacity) || !(m.shininess >= 0.0f) || !std::isfinite(m.shininess)) std::abort();
        }
    } catch (const rayscope::InputError&) {
    }
    return 0;
}
