#pragma once
// tinyobjloader as the tokenizer of OBJ and MTL files: the only files that include the library. Its gaps are
// closed here, so that readers see statements with their lines:
// - Callbacks do not have the line number. The text is passed through a stream buffer that holds one line at
//   a time and counts.
// - A word in place of a number is read as 0, and so are "nan" and "inf". Such lines are parsed again.
// - Indices that do not fit in an int become other numbers. They are errors here.
// - A byte order mark, lines continued by a backslash and comments behind statements are not understood. They
//   are removed from the text.
// - Names of materials and material files end at the first blank, or keep trailing blanks. They are taken
//   from the line.
// - Unknown statements are skipped silently, and so is a Tr that contradicts d. They are reported.
#include <rayscope/vector.h>

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope::scene {

/// A corner of a face as written: indices from 1, or negative ones that count back from the last element; 0:
/// not given.
struct ObjIndices {
    int position = 0, texCoord = 0, normal = 0;
};

/// Called for the statements of an OBJ file in their order; `line` counts from 1. Names are without the
/// blanks around them.
struct ObjCallbacks {
    std::function<void(const glm::vec3& position, int line)> position;  ///< may be NaN or infinite
    std::function<void(const glm::vec2& texCoord, int line)> texCoord;
    std::function<void(const glm::vec3& normal, int line)> normal;
    std::function<void(std::span<const ObjIndices> corners, int line)> face;
    std::function<void(std::string_view name, int line)> useMaterial;
    std::function<void(std::string_view files, int line)> materialLibrary;
    std::function<void(std::string_view keyword, int line)> unknown;  ///< not for o, g and s
};

/// Splits the text of an OBJ file into statements. Throws InputError, at a line of `path`, where a number is
/// missing or invalid.
void tokenizeObj(const std::string& path, std::string text, const ObjCallbacks& callbacks);

/// A material as written in an MTL file, with the defaults of tinyobjloader.
struct MtlMaterial {
    std::string name;
    Rgb kd, ks;
    float shininess, opacity;
    int illum;
    std::string kdTexture;  ///< file name; empty: none
    bool clampsTexture;
};

struct MtlContent {
    /// Both d and Tr are given, and d is not 1 − Tr.
    struct OpacityConflict {
        std::string material;
        float d, tr;
        int line;
    };
    std::vector<MtlMaterial> materials;
    std::vector<OpacityConflict> opacityConflicts;
    std::set<std::string> ignored;  ///< statements and options without effect
};

/// Reads the text of an MTL file. Throws InputError where tinyobjloader reports an error.
MtlContent tokenizeMtl(const std::string& path, std::string text);

}  // namespace rayscope::scene
