// Textures and materials of a glTF document.
#include <fmt/format.h>

#include <algorithm>

#include "scene/mesh_files/gltf/document.h"

namespace rayscope::scene {

namespace {

glm::dvec3 colorOf(const JsonObject& object, std::string_view key, const glm::dvec3& fallback) {
    const std::vector<double> values = object.numbers(key, 3);
    return values.empty() ? fallback : glm::dvec3(values[0], values[1], values[2]);
}

void readImages(const JsonObject& root, GltfDocument& document) {
    for (const JsonObject& object : root.objects("images"))
        document.images.push_back({.name = object.text("name"),
                                   .uri = object.text("uri"),
                                   .view = object.index("bufferView", document.views.size(), "bufferViews")});
}

/// The numbers of OpenGL are the values of the format.
GltfTexture readSampler(const JsonObject& sampler) {
    constexpr std::uint64_t kClampToEdge = 33071, kMirroredRepeat = 33648, kRepeat = 10497, kNearest = 9728;
    GltfTexture texture{.isNearest = sampler.integer("magFilter", 0) == kNearest};
    const auto read = [&](std::string_view key, bool& repeats) {
        const std::uint64_t mode = sampler.integer(key, kRepeat);
        if (mode != kRepeat && mode != kClampToEdge && mode != kMirroredRepeat)
            sampler.fail(key, fmt::format("expected 33071, 33648 or 10497, got {}", mode));
        repeats = mode != kClampToEdge;
        texture.isMirrored |= mode == kMirroredRepeat;
    };
    read("wrapS", texture.repeatsS);
    read("wrapT", texture.repeatsT);
    return texture;
}

void readTextures(const JsonObject& root, GltfDocument& document) {
    std::vector<GltfTexture> samplers;
    for (const JsonObject& sampler : root.objects("samplers")) samplers.push_back(readSampler(sampler));
    for (const JsonObject& object : root.objects("textures")) {
        const GltfIndex sampler = object.index("sampler", samplers.size(), "samplers");
        GltfTexture texture = sampler ? samplers[*sampler] : GltfTexture{};
        texture.image = object.index("source", document.images.size(), "images");
        document.textures.push_back(texture);
    }
}

std::optional<GltfTextureUse> textureUse(const JsonObject& owner, std::string_view key,
                                         const GltfDocument& document) {
    const auto object = owner.object(key);
    if (!object) return std::nullopt;
    GltfTextureUse use{.texture = object->requiredIndex("index", document.textures.size(), "textures"),
                       .texCoord = object->integer("texCoord", 0)};
    if (const auto extension = object->extension("KHR_texture_transform")) {
        GltfTextureTransform transform{.rotation = extension->number("rotation", 0.0)};
        if (const auto v = extension->numbers("offset", 2); !v.empty()) transform.offset = {v[0], v[1]};
        if (const auto v = extension->numbers("scale", 2); !v.empty()) transform.scale = {v[0], v[1]};
        use.transform = transform;
        use.texCoord = extension->integer("texCoord", use.texCoord);
    }
    return use;
}

void readMetallicRoughness(const JsonObject& object, const GltfDocument& document, GltfMaterial& material) {
    if (const auto v = object.numbers("baseColorFactor", 4); !v.empty())
        material.baseColor = {v[0], v[1], v[2], v[3]};
    material.baseColorTexture = textureUse(object, "baseColorTexture", document);
    material.metallicRoughnessTexture = textureUse(object, "metallicRoughnessTexture", document);
    material.metallic = object.number("metallicFactor", 1.0);
    material.roughness = object.number("roughnessFactor", 1.0);
}

void readSpecularGlossiness(const JsonObject& object, const GltfDocument& document, GltfMaterial& material,
                            Oddities& oddities) {
    material.baseColor = glm::dvec4(1.0);
    if (const auto v = object.numbers("diffuseFactor", 4); !v.empty())
        material.baseColor = {v[0], v[1], v[2], v[3]};
    material.baseColorTexture = textureUse(object, "diffuseTexture", document);
    material.metallicRoughnessTexture.reset();
    material.specular = colorOf(object, "specularFactor", glm::dvec3(1.0));
    material.roughness = 1.0 - object.number("glossinessFactor", 1.0);
    if (object.has("specularGlossinessTexture"))
        oddities.add(Severity::Note,
                     "textures of specular colour and glossiness; only their factors are used");
}

GltfAlphaMode alphaModeOf(const JsonObject& object) {
    const std::string mode = object.text("alphaMode", "OPAQUE");
    if (mode == "BLEND") return GltfAlphaMode::Blend;
    if (mode == "MASK") return GltfAlphaMode::Mask;
    if (mode != "OPAQUE")
        object.fail("alphaMode", fmt::format("expected OPAQUE, MASK or BLEND, got '{}'", mode));
    return GltfAlphaMode::Opaque;
}

/// Factors beyond 0 … 1 are not allowed by the format.
void clampFactors(GltfMaterial& material, Oddities& oddities) {
    const GltfMaterial before = material;
    material.baseColor = glm::clamp(material.baseColor, 0.0, 1.0);
    material.metallic = std::clamp(material.metallic, 0.0, 1.0);
    material.roughness = std::clamp(material.roughness, 0.0, 1.0);
    if (material.specular) material.specular = glm::clamp(*material.specular, 0.0, 1.0);
    if (material.baseColor != before.baseColor || material.metallic != before.metallic ||
        material.roughness != before.roughness || material.specular != before.specular)
        oddities.add(Severity::Warning, "materials with factors that are not between 0 and 1; clamped");
}

}  // namespace

void readGltfMaterials(const JsonObject& root, GltfDocument& document, Oddities& oddities) {
    readImages(root, document);
    readTextures(root, document);
    for (const JsonObject& object : root.objects("materials")) {
        GltfMaterial material{.name = object.text("name")};
        if (const auto pbr = object.object("pbrMetallicRoughness"))
            readMetallicRoughness(*pbr, document, material);
        if (const auto extension = object.extension("KHR_materials_pbrSpecularGlossiness"))
            readSpecularGlossiness(*extension, document, material, oddities);
        material.alphaMode = alphaModeOf(object);
        material.alphaCutoff = object.number("alphaCutoff", 0.5);
        clampFactors(material, oddities);
        if (object.has("normalTexture")) oddities.add(Severity::Note, "normal maps; ignored");
        if (object.has("occlusionTexture")) oddities.add(Severity::Note, "occlusion maps; ignored");
        if (object.has("emissiveTexture") ||
            colorOf(object, "emissiveFactor", glm::dvec3(0.0)) != glm::dvec3(0.0))
            oddities.add(Severity::Note, "materials that emit light; their emission is ignored");
        document.materials.push_back(material);
    }
}

}  // namespace rayscope::scene
