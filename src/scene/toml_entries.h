#pragma once
// What a scene file may say: plain values as written, before names are resolved and files are opened, and the
// records that describe their keys.
#include <rayscope/scene.h>

#include "scene/toml_record.h"

namespace rayscope::scene {

/// A word of the file that must be looked up elsewhere, and where it stands.
struct LocatedText {
    std::string text;
    SourcePosition position;
};

struct TextureEntry {
    LocatedText file;  ///< empty: `image` holds a generated texture
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
    std::optional<LocatedText> material;
    std::string ifMissing;  ///< what to do when the file is not there
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
