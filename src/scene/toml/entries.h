#pragma once
// The tables of a scene file as plain values, before names are resolved and files are loaded.
#include <rayscope/scene.h>

#include "scene/toml/record.h"
#include "scene/toml/shapes.h"

namespace rayscope::scene {

/// A file name or the name of a material, with its position for later errors.
struct LocatedText {
    std::string text;
    SourcePosition position;
};

struct TextureEntry {
    LocatedText file;  ///< empty: `image` is a generated texture
    RgbImage image;    ///< linear
    TextureWrap wrap = TextureWrap::Repeat;
};

struct MaterialEntry {
    Material material;
    std::optional<TextureEntry> texture;
};

struct MeshEntry {
    MeshInstance instance;
    std::optional<LocatedText> file;
    MeshGenerator generate;  ///< instead of `file`
    std::optional<LocatedText> material;
    SourcePosition vertexColors;  ///< of the key; its value is in `instance`
    std::string ifMissing;        ///< advice for the error if the file does not exist
};

struct SphereEntry {
    SphereInstance instance;
    std::optional<LocatedText> material;
};

struct EnvironmentEntry {
    std::array<LocatedText, 6> cube;
    LocatedText equirect;
    bool sky = false;
};

CameraDescription readCamera(const TomlValue& value);
Light readLight(const TomlValue& value);
MaterialEntry readMaterial(const TomlValue& value);
MeshEntry readMesh(const TomlValue& value);
SphereEntry readSphere(const TomlValue& value);
EnvironmentEntry readEnvironment(const TomlValue& value);

}  // namespace rayscope::scene
