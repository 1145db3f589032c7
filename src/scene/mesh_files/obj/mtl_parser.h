#pragma once
#include <rayscope/scene.h>

#include "scene/mesh_files/obj/mtl_texture.h"
#include "scene/mesh_files/obj/tinyobj_mtl.h"
#include "scene/oddities.h"

namespace rayscope::scene {

/// A material of an MTL file, checked.
struct ParsedMaterial {
    std::string name;  ///< as written, with quotes and comments; may be empty
    int line = 0;      ///< of newmtl
    MtlStatements statements{};
    std::string texture{};  ///< the file of map_Kd as written; empty: none
    bool clampsTexture = false;
    int opacityLine = 0;  ///< of the last d or Tr
    int textureLine = 0;
};

/// Parses the text of readTextFile(). Statements with values that cannot be used are left out; values out of
/// range are clamped. All of this is added to `oddities`. A second definition of a material changes the
/// first.
std::vector<ParsedMaterial> parseMtl(const std::string& path, std::string_view text, Oddities& oddities);

}  // namespace rayscope::scene
