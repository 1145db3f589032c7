#include <cstdint>
#include <cstdlib>

#include "fuzz/memory_file.h"
#include "scene/mesh_files/read_mesh_file.h"

namespace {

/// Aborts if the mesh breaks an invariant of MeshData that the rest of the program relies on.
void check(const rayscope::scene::ImportedMesh& mesh) {
    const rayscope::MeshData& data = *mesh.data;
    const std::size_t vertices = data.positions.size();
    const auto isComplete = [&](std::size_t count) { return count == 0 || count == vertices; };
    if (!isComplete(data.normals.size()) || !isComplete(data.texCoords.size()) ||
        !isComplete(data.colors.size()))
        std::abort();
    for (const glm::uvec3& triangle : data.triangles)
        if (triangle.x >= vertices || triangle.y >= vertices || triangle.z >= vertices) std::abort();
    if (!data.materialSlots.empty() && data.materialSlots.size() != data.triangles.size()) std::abort();
    if (mesh.materials.empty()) std::abort();
    for (const std::uint16_t slot : data.materialSlots)
        if (slot >= mesh.materials.size()) std::abort();
}

}  // namespace

/// Any bytes give a valid mesh or InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const rayscope::test::MemoryFile file(std::string("fuzzed") + RAYSCOPE_FUZZED_SUFFIX);
    rayscope::Diagnostics notes;
    const rayscope::LoadControl control;
    rayscope::scene::TextureCache textures(notes, control);
    try {
        check(rayscope::scene::readMeshFile(file.write(data, size), {textures, notes, control, true}));
    } catch (const rayscope::InputError&) {
    }
    return 0;
}
