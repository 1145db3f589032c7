#include "scene/mesh_files/gltf/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace rayscope::scene {

namespace {

constexpr std::string_view kDraco = "KHR_draco_mesh_compression";
constexpr std::string_view kMeshopt = "EXT_meshopt_compression";

bool isRead(std::string_view extension) {
    constexpr std::array<std::string_view, 6> kRead{
        "KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "KHR_lights_punctual",
        "KHR_texture_transform", "KHR_xmp_json_ld",         "KHR_materials_pbrSpecularGlossiness"};
    return std::find(kRead.begin(), kRead.end(), extension) != kRead.end();
}

/// Extensions that change how surfaces look, but neither geometry nor the format of images.
bool isOfMaterials(std::string_view extension) {
    return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_technique");
}

void checkVersion(const JsonObject& root) {
    const std::string version = root.requiredObject("asset").textOrNumber("version");
    const std::string least = root.requiredObject("asset").text("minVersion", "2.0");
    if (least != "2" && least != "2.0")
        root.fail("asset.minVersion",
                  fmt::format("glTF {} is not supported; export the file as glTF 2.0", least));
    if (version == "2" || version.starts_with("2.")) return;
    if (version == "1" || version.starts_with("1."))
        root.fail("asset.version",
                  fmt::format("glTF {} is not supported; convert the file to glTF 2.0", version));
    root.fail("asset.version", fmt::format("expected 2.0, got '{}'", version));
}

void checkExtensions(const JsonObject& root, Oddities& oddities) {
    const std::vector<std::string> required = root.texts("extensionsRequired");
    for (const std::string& extension : required) {
        if (isRead(extension) || isOfMaterials(extension)) continue;
        const std::string_view advice = extension == kDraco || extension == kMeshopt
                                            ? "; export it without compression"
                                            : "; export it without this extension";
        root.fail("", fmt::format("the file requires the extension {}, which is not supported{}", extension,
                                  advice));
    }
    // Files with these often have a fallback; where they have none, it is said.
    constexpr std::array<std::string_view, 4> kReportedElsewhere{kDraco, kMeshopt, "KHR_texture_basisu",
                                                                 "EXT_texture_webp"};
    for (const std::string& extension : root.texts("extensionsUsed"))
        if (!isRead(extension) && std::find(kReportedElsewhere.begin(), kReportedElsewhere.end(),
                                            extension) == kReportedElsewhere.end())
            oddities.add(Severity::Note,
                         fmt::format("the extension {} is not supported; ignored", extension));
}

GltfComponent readComponent(const JsonObject& object) {
    const std::uint64_t value = object.integer("componentType");
    if (value < 5120 || value > 5126 || value == 5124)
        object.fail("componentType",
                    fmt::format("expected 5120, 5121, 5122, 5123, 5125 or 5126, got {}", value));
    return static_cast<GltfComponent>(value);
}

void readBuffers(const JsonObject& root, GltfDocument& document) {
    for (const JsonObject& object : root.objects("buffers")) {
        GltfBuffer& buffer = document.buffers.emplace_back();
        if (object.has("uri")) buffer.uri = object.text("uri");
        buffer.byteLength = object.integer("byteLength");
    }
    for (const JsonObject& object : root.objects("bufferViews")) {
        GltfBufferView view{.buffer = object.requiredIndex("buffer", document.buffers.size(), "buffers"),
                            .byteOffset = object.integer("byteOffset", 0),
                            .byteLength = object.integer("byteLength"),
                            .byteStride = object.integer("byteStride", 0)};
        view.isCompressed = object.extension(kMeshopt).has_value();
        document.views.push_back(view);
    }
}

GltfSparse readSparse(const JsonObject& object, std::uint64_t count, const GltfDocument& document) {
    const JsonObject indices = object.requiredObject("indices"), values = object.requiredObject("values");
    const std::size_t views = document.views.size();
    GltfSparse sparse{.count = object.integer("count"),
                      .indicesView = indices.requiredIndex("bufferView", views, "bufferViews"),
                      .valuesView = values.requiredIndex("bufferView", views, "bufferViews"),
                      .indicesOffset = indices.integer("byteOffset", 0),
                      .valuesOffset = values.integer("byteOffset", 0),
                      .indexType = readComponent(indices)};
    if (sparse.indexType != GltfComponent::UnsignedByte && sparse.indexType != GltfComponent::UnsignedShort &&
        sparse.indexType != GltfComponent::UnsignedInt)
        indices.fail("componentType", "expected an unsigned integer type");
    if (sparse.count > count)
        object.fail("count", fmt::format("expected at most {}, the count of the accessor, got {}", count,
                                         sparse.count));
    return sparse;
}

void readAccessors(const JsonObject& root, GltfDocument& document) {
    constexpr std::array<std::pair<std::string_view, std::uint32_t>, 7> kTypes{
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
    for (const JsonObject& object : root.objects("accessors")) {
        const std::string type = object.text("type");
        const auto found =
            std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& t) { return t.first == type; });
        if (found == kTypes.end())
            object.fail("type", fmt::format("expected SCALAR, VEC2, VEC3 …, got '{}'", type));
        GltfAccessor accessor{.view = object.index("bufferView", document.views.size(), "bufferViews"),
                              .byteOffset = object.integer("byteOffset", 0),
                              .count = object.integer("count"),
                              .component = readComponent(object),
                              .components = found->second,
                              .normalized = object.boolean("normalized", false)};
        if (const auto sparse = object.object("sparse"))
            accessor.sparse = readSparse(*sparse, accessor.count, document);
        document.accessors.push_back(accessor);
    }
}

GltfPrimitive readPrimitive(const JsonObject& object, const GltfDocument& document) {
    const std::size_t accessors = document.accessors.size();
    GltfPrimitive primitive{.mode = object.integer("mode", 4),
                            .indices = object.index("indices", accessors, "accessors"),
                            .material = object.index("material", document.materials.size(), "materials")};
    if (primitive.mode > 6) object.fail("mode", fmt::format("expected 0 to 6, got {}", primitive.mode));
    primitive.attributes = readGltfAttributes(object.requiredObject("attributes"), document);
    for (const JsonObject& target : object.objects("targets"))
        primitive.targets.push_back(readGltfAttributes(target, document));
    primitive.isDraco = object.extension(kDraco).has_value();
    return primitive;
}

void readMeshes(const JsonObject& root, GltfDocument& document) {
    for (const JsonObject& object : root.objects("meshes")) {
        GltfMesh& mesh = document.meshes.emplace_back();
        mesh.weights = object.numbers("weights");
        if (!object.has("primitives")) object.fail("", "the member 'primitives' is missing");
        for (const JsonObject& primitive : object.objects("primitives"))
            mesh.primitives.push_back(readPrimitive(primitive, document));
    }
}

}  // namespace

GltfAttributes readGltfAttributes(const JsonObject& object, const GltfDocument& document) {
    GltfAttributes attributes;
    for (const std::string& name : object.keys())
        attributes[name] = object.requiredIndex(name, document.accessors.size(), "accessors");
    return attributes;
}

GltfDocument readGltfDocument(const JsonObject& root, Oddities& oddities) {
    GltfDocument document;
    checkVersion(root);
    checkExtensions(root, oddities);
    readBuffers(root, document);
    readAccessors(root, document);
    readGltfMaterials(root, document, oddities);
    readMeshes(root, document);
    readGltfNodes(root, document, oddities);
    if (root.sizeOf("animations") > 0)
        oddities.add(Severity::Note, "animations; ignored, nodes keep their transforms");
    return document;
}

}  // namespace rayscope::scene
