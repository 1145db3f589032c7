// The table of mesh file formats.
#include "scene/mesh_files/read_mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/file_suffix.h"
#include "scene/mesh_files/gltf/gltf_reader.h"
#include "scene/mesh_files/obj/obj_reader.h"
#include "scene/mesh_files/ply/ply_reader.h"
#include "scene/mesh_files/stl/stl_reader.h"
#include "scene/source_files.h"

namespace rayscope::scene {

namespace {

struct MeshFormat {
    std::string_view suffix;
    ImportedMesh (*read)(const std::string& path, const ImportContext& context);
};

constexpr std::array kFormats{MeshFormat{".obj", readObj}, MeshFormat{".ply", readPly},
                              MeshFormat{".stl", readStl}, MeshFormat{".gltf", readGltf},
                              MeshFormat{".glb", readGltf}};

const MeshFormat* formatOf(std::string_view path) {
    const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const MeshFormat& format) {
        return base::hasSuffix(path, format.suffix);
    });
    return found == kFormats.end() ? nullptr : &*found;
}

}  // namespace

bool isMeshFileName(std::string_view path) { return formatOf(path) != nullptr; }

std::vector<std::string_view> meshFileSuffixes() {
    std::vector<std::string_view> suffixes;
    suffixes.reserve(std::size(kFormats));
    for (const MeshFormat& format : kFormats) suffixes.push_back(format.suffix);
    return suffixes;
}

ImportedMesh readMeshFile(const std::string& path, const ImportContext& context) {
    const MeshFormat* format = formatOf(path);
    if (!format)
        throw InputError(
            fmt::format("unknown mesh format; expected a file {}", fmt::join(meshFileSuffixes(), ", ")),
            {path});
    refuseSpecialFile(path);
    return format->read(path, context);
}

void noteCamerasAndLights(const ImportedMesh& mesh, const std::string& path, Diagnostics& notes) {
    if (mesh.cameras.empty() && mesh.lights.empty()) return;
    notes.push_back(
        {Severity::Note,
         fmt::format("the cameras ({}) and lights ({}) of the file are ignored; a scene has its own",
                     mesh.cameras.size(), mesh.lights.size()),
         {path}});
}

}  // namespace rayscope::scene
