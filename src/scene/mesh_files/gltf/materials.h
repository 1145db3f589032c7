#pragma once
#include <map>
#include <tuple>

#include "scene/imported_mesh.h"
#include "scene/mesh_files/gltf/resources.h"

namespace rayscope::scene {

/// Converts materials of metalness and roughness into those of Phong's model, and loads their textures.
///
/// With base colour b, metalness m, roughness r and smoothness s = (1 − r)²: kd = b · (1 − m·s),
/// ks = min(s · mix(0.04, b, m), 1 − kd), shininess = (2/r⁴ − 2) / 4, between 1 and 10000. The share 1 − s of
/// the specular reflection, which rough surfaces scatter widely, counts as diffuse. 2/α² − 2 with α = r² is
/// the exponent of the half-vector form (Karis 2013, "Specular BRDF Reference"); that of the reflected
/// vector, which Phong's model uses, is about a quarter of it.
class GltfMaterialConverter {
  public:
    /// The arguments must outlive the object.
    GltfMaterialConverter(const std::string& path, const GltfDocument& document, GltfResources& resources,
                          TextureCache& textures, Diagnostics& notes, Oddities& oddities)
        : path_(path),
          document_(document),
          resources_(resources),
          textures_(textures),
          notes_(notes),
          oddities_(oddities) {}

    /// The material with this index, or that of primitives without one. An image that cannot be read is a
    /// warning, and the factors are used alone.
    Material convert(GltfIndex index);

  private:
    using SharedTexture = std::shared_ptr<const Texture>;
    /// The image of a texture, null if it cannot be read.
    SharedTexture open(const GltfTextureUse& use);
    SharedTexture load(std::uint32_t image, TextureWrap wrap);
    SharedTexture tinted(const SharedTexture& texture, const Rgb& factor);
    /// Replaces metalness and roughness by their means over the texture.
    void averageMetallicRoughness(GltfMaterial& material);
    void noteAlpha(const GltfMaterial& material);
    void noteSampling(const GltfTexture& texture);

    const std::string& path_;
    const GltfDocument& document_;
    GltfResources& resources_;
    TextureCache& textures_;
    Diagnostics& notes_;
    Oddities& oddities_;
    std::map<std::pair<std::uint32_t, TextureWrap>, SharedTexture> loaded_{};
    std::map<std::tuple<const Texture*, float, float, float>, SharedTexture> tinted_{};
    std::size_t tintedTexels_ = 0;
};

}  // namespace rayscope::scene
