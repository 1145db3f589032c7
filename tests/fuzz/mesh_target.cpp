#include "fuzz/memory_file.h"
#include "scene/mesh_files/read_mesh_file.h"

namespace rayscope::test {

namespace {

/// The invariants of MeshData that the rest of the program relies on.
void checkMesh(const scene::ImportedMesh& mesh) {
    const MeshData& data = *mesh.data;
    const std::size_t vertices = data.positions.size();
    const auto isComplete = [&](std::size_t count) { return count == 0 || count == vertices; };
    require(isComplete(data.normals.size()), "all vertices have normals or none");
    require(isComplete(data.texCoords.size()), "all vertices have texture coordinates or none");
    require(isComplete(data.colors.size()), "all vertices have colours or none");
    for (const glm::uvec3& triangle : data.triangles)
        require(triangle.x < vertices && triangle.y < vertices && triangle.z < vertices,
                "triangles have vertices that exist");
    require(data.materialSlots.empty() || data.materialSlots.size() == data.triangles.size(),
            "all triangles have a material slot or none");
    require(!mesh.materials.empty(), "a mesh has a material");
    for (const std::uint16_t slot : data.materialSlots)
        require(slot < mesh.materials.size(), "triangles have materials that exist");
}

/// Any bytes give a valid mesh or InputError.
bool fuzzMesh(const MemoryFile& file, FuzzInput input) {
    Diagnostics notes;
    const LoadControl control;
    scene::TextureCache textures(notes, control);
    try {
        checkMesh(scene::readMeshFile(file.write(input), {textures, notes, control, true}));
    } catch (const InputError&) {
    }
    return true;
}

}  // namespace

bool fuzzObj(FuzzInput input) {
    static const MemoryFile file("fuzzed.obj");
    return fuzzMesh(file, input);
}

bool fuzzPly(FuzzInput input) {
    static const MemoryFile file("fuzzed.ply");
    return fuzzMesh(file, input);
}

bool fuzzStl(FuzzInput input) {
    static const MemoryFile file("fuzzed.stl");
    return fuzzMesh(file, input);
}

bool fuzzGltf(FuzzInput input) {
    static const MemoryFile file("fuzzed.gltf");
    return fuzzMesh(file, input);
}

}  // namespace rayscope::test
