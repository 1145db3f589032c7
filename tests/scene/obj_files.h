#pragma once
// A fixture for texts of OBJ and MTL files.
#include <gmock/gmock.h>

#include "scene/mesh_files/obj/obj_reader.h"
#include "scene_files.h"

namespace rayscope::test {

/// A triangle with its corners at (0 0 0), (1 0 0) and (0 1 0), without its face.
inline const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

class ObjFiles : public SceneFiles {
  protected:
    SceneDescription read(std::string_view text) {
        notes_.clear();
        return load(write("mesh.obj", text));
    }
    std::string failure(std::string_view text) { return errorOf(write("mesh.obj", text)); }
    /// The mesh of an OBJ file whose colours are shown.
    std::shared_ptr<const MeshData> readWithColors(std::string_view text) {
        notes_.clear();
        const LoadControl control;
        scene::TextureCache textures(notes_, control);
        return scene::readObj(write("mesh.obj", text), {textures, notes_, control, true}).data;
    }
    static const MeshData& meshOf(const SceneDescription& scene) { return *scene.meshes.at(0).data; }

    /// The material of a triangle that uses the first material of this MTL file.
    Material materialOf(std::string_view mtl) {
        write("m.mtl", mtl);
        return read("mtllib m.mtl\n" + kTriangle + "usemtl m\nf 1 2 3\n").materials.at(0);
    }
    /// All notes of the last file, one per line, without the folder.
    std::string notesText() const {
        std::string text = SceneFiles::notesText();
        const std::string prefix = folder_.string() + "/";
        for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
            text.erase(at, prefix.size());
        return text;
    }
};

}  // namespace rayscope::test
