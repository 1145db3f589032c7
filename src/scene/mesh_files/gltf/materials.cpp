#include "scene/mesh_files/gltf/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/srgb.h"

namespace rayscope::scene {

namespace {

float shininessOf(double roughness) {
    constexpr double kLeast = 1.0, kLargest = 10000.0;
    const double alpha = roughness * roughness;
    return static_cast<float>(std::clamp((2.0 / (alpha * alpha) - 2.0) / 4.0, kLeast, kLargest));
}

/// The mean of the pixels.
glm::dvec3 meanOf(const RgbImage& image) {
    glm::dvec3 sum(0.0);
    for (const Rgb& pixel : image.pixels) sum += glm::dvec3(pixel);
    return sum / static_cast<double>(std::max<std::size_t>(image.pixels.size(), 1));
}

}  // namespace

Material GltfMaterialConverter::convert(GltfIndex index) {
    GltfMaterial from = index ? document_.materials[*index] : GltfMaterial{.name = "default"};
    averageMetallicRoughness(from);
    noteAlpha(from);
    const SharedTexture texture = from.baseColorTexture ? open(*from.baseColorTexture) : nullptr;

    const double smoothness = (1.0 - from.roughness) * (1.0 - from.roughness);
    const glm::dvec3 factor(from.baseColor);
    const double metallic = from.specular ? 0.0 : from.metallic;
    const glm::dvec3 tint = factor * (1.0 - metallic * smoothness);
    const glm::dvec3 base = texture && metallic * smoothness > 0.0 ? factor * meanOf(texture->image) : factor;
    const glm::dvec3 specular = from.specular ? *from.specular : glm::mix(glm::dvec3(0.04), base, metallic);
    if (texture && metallic * smoothness > 0.0)
        oddities_.add(Severity::Note,
                      "textured metals; their reflections have the mean colour of the texture");

    Material material{.name = from.name, .kd = Rgb(tint)};
    if (material.name.empty()) material.name = fmt::format("material {}", *index);
    const glm::dvec3 kd = base * (1.0 - metallic * smoothness);
    material.ks = Rgb(glm::min(smoothness * specular, glm::max(1.0 - kd, 0.0)));
    material.shininess = shininessOf(from.roughness);
    if (texture) noteSampling(document_.textures[from.baseColorTexture->texture]);
    if (from.alphaMode == GltfAlphaMode::Blend) material.opacity = static_cast<float>(from.baseColor.a);
    if (from.alphaMode == GltfAlphaMode::Mask)
        material.opacity = from.baseColor.a < from.alphaCutoff ? 0.0f : 1.0f;
    if (texture) material.kdTexture = tinted(texture, Rgb(tint));
    return material;
}

void GltfMaterialConverter::noteAlpha(const GltfMaterial& material) {
    if (material.alphaMode != GltfAlphaMode::Opaque && material.baseColorTexture)
        oddities_.add(Severity::Note,
                      "transparent textures (alphaMode BLEND or MASK); the alpha of their texels is ignored");
}

void GltfMaterialConverter::noteSampling(const GltfTexture& texture) {
    if (texture.isMirrored)
        oddities_.add(Severity::Note, "textures that repeat mirrored; they repeat without mirroring");
    if (texture.repeatsS != texture.repeatsT)
        oddities_.add(Severity::Note, "textures that clamp in one direction only; they repeat in both");
    if (texture.isNearest)
        oddities_.add(Severity::Note,
                      "textures with nearest-neighbour filter; the setting texture_filter decides");
}

void GltfMaterialConverter::averageMetallicRoughness(GltfMaterial& material) {
    if (!material.metallicRoughnessTexture) return;
    const SharedTexture texture = open(*material.metallicRoughnessTexture);
    if (!texture) return;
    // The channels are data without the sRGB curve, which the reader of images has decoded.
    double roughness = 0.0, metallic = 0.0;
    for (const Rgb& pixel : texture->image.pixels) {
        roughness += static_cast<double>(image::linearToSrgb(pixel.g));
        metallic += static_cast<double>(image::linearToSrgb(pixel.b));
    }
    const auto count = static_cast<double>(std::max<std::size_t>(texture->image.pixels.size(), 1));
    material.roughness *= roughness / count;
    material.metallic *= metallic / count;
    oddities_.add(Severity::Note, "textures of metalness and roughness; their means are used");
}

GltfMaterialConverter::SharedTexture GltfMaterialConverter::open(const GltfTextureUse& use) {
    const GltfTexture& texture = document_.textures[use.texture];
    if (!texture.image) {
        oddities_.add(Severity::Warning,
                      "textures without an image in a supported format (PNG, JPEG); ignored");
        return nullptr;
    }
    const auto wrap = texture.repeatsS || texture.repeatsT ? TextureWrap::Repeat : TextureWrap::Clamp;
    const auto [entry, isNew] = loaded_.try_emplace({*texture.image, wrap});
    if (!isNew) return entry->second;
    try {
        entry->second = load(*texture.image, wrap);
    } catch (const InputError& error) {
        const Diagnostic& reason = error.diagnostic();
        const std::string file = reason.position.file == path_ ? "" : reason.position.file + ": ";
        oddities_.add(Severity::Warning, fmt::format("texture {}: {}{}; the base colour is used instead",
                                                     use.texture, file, reason.message));
    }
    return entry->second;
}

GltfMaterialConverter::SharedTexture GltfMaterialConverter::load(std::uint32_t image, TextureWrap wrap) {
    const GltfImageSource source = resources_.image(image);
    if (!source.path.empty()) return textures_.open(source.path, wrap);
    const std::string name = fmt::format("{}: images[{}]", path_, image);
    return std::make_shared<Texture>(Texture{name, decodeImage(source.bytes, name, &notes_), wrap});
}

GltfMaterialConverter::SharedTexture GltfMaterialConverter::tinted(const SharedTexture& texture,
                                                                   const Rgb& factor) {
    if (factor == Rgb(1.0f)) return texture;
    SharedTexture& result = tinted_[{texture.get(), factor.r, factor.g, factor.b}];
    if (result) return result;
    // One image with many factors must not claim all memory.
    constexpr std::size_t kMaxTexels = std::size_t{1} << 27;
    tintedTexels_ += texture->image.pixels.size();
    if (tintedTexels_ > kMaxTexels) {
        oddities_.add(
            Severity::Warning,
            "textures with many colour factors (more than 2^27 texels in all); the factors are ignored");
        return result = texture;
    }
    auto copy = std::make_shared<Texture>(*texture);
    for (Rgb& pixel : copy->image.pixels) pixel *= factor;
    return result = std::move(copy);
}

}  // namespace rayscope::scene
