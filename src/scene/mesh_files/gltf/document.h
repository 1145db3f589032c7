#pragma once
// A glTF 2.0 document as plain values. Indices are checked against the arrays that they refer to.
#include <rayscope/vector.h>

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/mesh_files/gltf/json_object.h"
#include "scene/oddities.h"

namespace rayscope::scene {

using GltfIndex = std::optional<std::uint32_t>;  ///< nothing: the member is absent

struct GltfBuffer {
    std::optional<std::string> uri;  ///< nothing: the binary chunk of a GLB file
    std::uint64_t byteLength = 0;
};

struct GltfBufferView {
    std::uint32_t buffer = 0;
    std::uint64_t byteOffset = 0, byteLength = 0;
    std::uint64_t byteStride = 0;  ///< 0: elements follow one another
    bool isCompressed = false;     ///< EXT_meshopt_compression
};

/// The values of the format.
enum class GltfComponent : std::uint32_t {
    Byte = 5120,
    UnsignedByte = 5121,
    Short = 5122,
    UnsignedShort = 5123,
    UnsignedInt = 5125,
    Float = 5126
};

struct GltfSparse {
    std::uint64_t count = 0;
    std::uint32_t indicesView = 0, valuesView = 0;
    std::uint64_t indicesOffset = 0, valuesOffset = 0;
    GltfComponent indexType = GltfComponent::UnsignedInt;
};

struct GltfAccessor {
    GltfIndex view{};  ///< nothing: zeros
    std::uint64_t byteOffset = 0, count = 0;
    GltfComponent component = GltfComponent::Float;
    std::uint32_t components = 1;  ///< per element
    bool normalized = false;
    std::optional<GltfSparse> sparse{};
};

/// KHR_texture_transform: scale, then rotation, then offset of the coordinates in the format's convention,
/// whose origin is the upper left corner.
struct GltfTextureTransform {
    glm::dvec2 offset{0.0}, scale{1.0};
    double rotation = 0.0;  ///< radians, counterclockwise on the image
};

struct GltfTextureUse {
    std::uint32_t texture = 0;
    std::uint64_t texCoord = 0;
    std::optional<GltfTextureTransform> transform{};
};

enum class GltfAlphaMode { Opaque, Mask, Blend };

struct GltfMaterial {
    std::string name{};
    glm::dvec4 baseColor{1.0};
    std::optional<GltfTextureUse> baseColorTexture{}, metallicRoughnessTexture{};
    double metallic = 1.0, roughness = 1.0;
    std::optional<glm::dvec3> specular{};  ///< of KHR_materials_pbrSpecularGlossiness, replaces metallic
    GltfAlphaMode alphaMode = GltfAlphaMode::Opaque;
    double alphaCutoff = 0.5;
};

struct GltfTexture {
    GltfIndex image{};
    bool repeatsS = true, repeatsT = true;  ///< else clamps
    bool isMirrored = false, isNearest = false;
};

struct GltfImage {
    std::string name{}, uri{};
    GltfIndex view{};
};

using GltfAttributes = std::map<std::string, std::uint32_t>;  ///< accessors by semantic

struct GltfPrimitive {
    std::uint64_t mode = 4;
    GltfIndex indices{}, material{};
    GltfAttributes attributes{};
    std::vector<GltfAttributes> targets{};  ///< displacements of morph targets
    bool isDraco = false;
};

struct GltfMesh {
    std::vector<GltfPrimitive> primitives{};
    std::vector<double> weights{};  ///< of the morph targets; missing ones are 0
};

struct GltfSkin {
    GltfIndex inverseBindMatrices{};
    std::vector<std::uint32_t> joints{};  ///< nodes
};

struct GltfNode {
    std::string name{};
    std::vector<std::uint32_t> children{};
    glm::dmat4 matrix{1.0};
    GltfIndex mesh{}, camera{}, light{}, skin{};
    std::vector<double> weights{};  ///< replace those of the mesh unless empty
    GltfAttributes instances{};     ///< EXT_mesh_gpu_instancing
};

struct GltfCamera {
    std::string name{};
    bool isPerspective = true;
    double yfov = 1.0;  ///< radians
};

struct GltfLight {
    std::string name{}, type{};
    glm::dvec3 color{1.0};
    double intensity = 1.0;
};

struct GltfDocument {
    std::vector<GltfBuffer> buffers{};
    std::vector<GltfBufferView> views{};
    std::vector<GltfAccessor> accessors{};
    std::vector<GltfImage> images{};
    std::vector<GltfTexture> textures{};
    std::vector<GltfMaterial> materials{};
    std::vector<GltfMesh> meshes{};
    std::vector<GltfSkin> skins{};
    std::vector<GltfCamera> cameras{};
    std::vector<GltfLight> lights{};
    std::vector<GltfNode> nodes{};
    std::vector<std::uint32_t> roots{};  ///< the nodes of the scene that is read
};

/// Reads all that the other files of this folder use. Throws InputError at members of wrong type or value and
/// at required extensions that are not supported; adds what is left out to `oddities`.
GltfDocument readGltfDocument(const JsonObject& root, Oddities& oddities);

/// Parts of readGltfDocument().
void readGltfMaterials(const JsonObject& root, GltfDocument& document, Oddities& oddities);
GltfAttributes readGltfAttributes(const JsonObject& object, const GltfDocument& document);
void readGltfNodes(const JsonObject& root, GltfDocument& document, Oddities& oddities);

}  // namespace rayscope::scene
