// Damaged and hostile glTF files: an error that names the place, never a crash.
#include <random>

#include "gltf_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class GltfDamage : public GltfFiles {};

/// A file with one of everything, as members of the document; accessors 0 positions, 1 indices, 2 sparse.
GltfBuilder everything() {
    GltfBuilder file;
    file.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    file.accessor(std::vector<std::uint16_t>{0, 1, 2}, "SCALAR");
    file.view(std::string(1, '\1'));
    file.view(std::string(12, '\0'));
    file.declare(
        R"("bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":3}})");
    return file;
}
const std::string kEverything =
    R"("scene":0,"extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}},)"
    R"("images":[{"bufferView":0}],"samplers":[{}],"textures":[{"source":0,"sampler":0}],)"
    R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"baseColorFactor":[1,1,1,1]},"alphaMode":"BLEND"}],)"
    R"("cameras":[{"type":"perspective","perspective":{"yfov":1}}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":2,"NORMAL":0},"indices":1,"material":0,"mode":4}]}],)"
    R"("nodes":[{"children":[1],"rotation":[0,0,0,1]},{"mesh":0,"camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}}],"scenes":[{"nodes":[0]}])";

/// A replacement in that file, and the message that it must cause.
struct WrongMember {
    const char* from;
    const char* to;
    const char* message;
};
const WrongMember kWrongMembers[] = {
    {R"("version":"2.0")", R"("version":"1.0")",
     "asset.version: glTF 1.0 is not supported; convert the file to glTF 2.0"},
    {R"("version":"2.0")", R"("version":true)", "asset.version: expected a string, got true"},
    {R"("version":"2.0")", R"("version":"2.0","minVersion":"2.1")",
     "asset.minVersion: glTF 2.1 is not supported"},
    {R"("asset":{"version":"2.0"},)", "", "the document: the member 'asset' is missing"},
    {R"("scene":0)", R"("scene":1)", "scene: index 1 is out of range: scenes has 1 elements"},
    {R"("scene":0)", R"("scene":"0")", "scene: expected an index into scenes, got \"0\""},
    {R"("index":0)", R"("index":-1)",
     "materials[0].pbrMetallicRoughness.baseColorTexture.index: expected an index into textures, got -1"},
    {R"("index":0)", R"("index":4294967296)",
     "materials[0].pbrMetallicRoughness.baseColorTexture.index: index 4294967296 is out of range: "
     "textures has 1 elements"},
    {R"("POSITION":2)", R"("POSITION":3)",
     "meshes[0].primitives[0].attributes.POSITION: index 3 is out of range: accessors has 3 elements"},
    {R"("POSITION":2)", R"("POSITION":1)", "accessors[1]: 1 components per element where 3 are expected"},
    {R"("indices":1)", R"("indices":0)", "accessors[0]: indices must be scalars of an unsigned integer type"},
    {R"("mode":4)", R"("mode":7)", "meshes[0].primitives[0].mode: expected 0 to 6, got 7"},
    {R"("attributes":{"POSITION":2,"NORMAL":0},)", "",
     "meshes[0].primitives[0]: the member 'attributes' is missing"},
    {R"("baseColorFactor":[1,1,1,1])", R"("baseColorFactor":[1,1,1])",
     "materials[0].pbrMetallicRoughness.baseColorFactor: expected 4 numbers, got [1,1,1]"},
    {R"("BLEND")", R"("ADD")", "materials[0].alphaMode: expected OPAQUE, MASK or BLEND, got 'ADD'"},
    {R"("yfov":1)", R"("yfov":0)", "cameras[0].perspective.yfov: expected an angle between 0 and π, got 0"},
    {R"("children":[1])", R"("children":[0])", "nodes[0] is its own ancestor"},
    {R"("children":[1])", R"("children":[2])",
     "nodes[0].children: index 2 is out of range: nodes has 2 elements"},
    {R"("rotation":[0,0,0,1])", R"("rotation":[0,0,0,0])",
     "nodes[0].rotation: the quaternion has the length 0"},
    {R"("rotation":[0,0,0,1])", R"("matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1])",
     "nodes[0].matrix: expected an affine map"},
    {R"("count":3)", R"("count":4)",
     "accessors[0]: 4 elements of 12 bytes at 0 exceed the 36 bytes of bufferViews[0]"},
    {R"("count":3)", R"("count":18446744073709551615)",
     "accessors[0]: 18446744073709551615 elements of 12 bytes at 0 exceed the 36 bytes of "
     "bufferViews[0]"},
    {R"("componentType":5126)", R"("componentType":5124)", "accessors[0].componentType: expected 5120"},
    {R"("componentType":5121)", R"("componentType":5126)",
     "accessors[2].sparse.indices.componentType: expected an unsigned integer type"},
    {R"("VEC3")", R"("VEC9")", "accessors[0].type: expected SCALAR, VEC2, VEC3 …, got 'VEC9'"},
    {R"("byteOffset":0,"byteLength":36)", R"("byteOffset":18446744073709551615,"byteLength":36)",
     "bufferViews[0]: 36 bytes at 18446744073709551615 exceed the"},
    {R"("byteLength":36)", R"("byteLength":36,"byteStride":8)",
     "elements of 12 bytes exceed the byteStride 8"},
    {"base64,", "base64,?", "buffers[0]: the data URI is not valid base64"},
    {R"("type":"point")", R"("type":"disk")",
     "extensions.KHR_lights_punctual.lights[0].type: expected point, directional or spot, got 'disk'"},
    {R"("scene":0)", R"("scene":0,"extensionsRequired":["KHR_draco_mesh_compression"])",
     "the document: the file requires the extension KHR_draco_mesh_compression, which is not supported; "
     "export it without compression"},
    {R"("scene":0)", R"("scene":0,"extensionsRequired":["EXT_texture_webp"])",
     "the file requires the extension EXT_texture_webp, which is not supported"},
    {R"("scenes":[{"nodes":[0]}])", R"("scenes":[{}])", "the scene of the file has no triangles"},
    {R"("POSITION":)", R"("POSITIONS":)", "the scene of the file has no triangles; "},
    {R"("scenes":[{"nodes":[0]}])", R"("scenes":{})", "scenes: expected an array, got {}"}};

TEST_F(GltfDamage, WrongMembersAreNamed) {
    const std::string whole = everything().embedded(kEverything);
    ASSERT_EQ(failure(whole), "");
    for (const auto& [from, to, message] : kWrongMembers) {
        std::string text = whole;
        const auto at = text.find(from);
        ASSERT_NE(at, text.npos) << from;
        text.replace(at, std::string_view(from).size(), to);
        EXPECT_THAT(failure(text), StartsWith("m.gltf: error: "));
        EXPECT_THAT(failure(text), HasSubstr(message));
    }
}

TEST_F(GltfDamage, DamagedJsonHasAPosition) {
    EXPECT_THAT(failure("{\n  \"asset\": {,}\n}"),
                StartsWith("m.gltf:2:13: error: not valid JSON: syntax error"));
    EXPECT_THAT(failure("{\"a\": 1e999}"), HasSubstr("not valid JSON: number overflow"));
    EXPECT_EQ(failure(""), "m.gltf: error: the file is empty");
    EXPECT_EQ(failure("[]"), "m.gltf: error: the document: expected an object, got []");
    EXPECT_THAT(failure(std::string("{\0\0", 3)), HasSubstr("not valid JSON"));
    EXPECT_EQ(failure("{\"a\":" + std::string(1'000'000, '[')),
              "m.gltf: error: the JSON is nested more than 512 levels deep");
    EXPECT_THAT(errorOf(write("m.glb", GltfBuilder::container("{\"a\":}   ", ""))),
                HasSubstr("m.glb: error: the JSON chunk is not valid, at its byte 6: syntax error"));
}

TEST_F(GltfDamage, DamagedContainersAreNamed) {
    const std::string whole = triangle().glb(oneMesh(R"("attributes":{"POSITION":0})"));
    const auto of = [&](const std::string& bytes) { return errorOf(write("m.glb", bytes)); };
    ASSERT_EQ(of(whole), "");
    EXPECT_EQ(of(whole.substr(0, 11)),
              "m.glb: error: damaged GLB file: it ends after 11 bytes; export or copy it again");
    EXPECT_THAT(of(whole.substr(0, whole.size() - 4)), HasSubstr("damaged GLB file: it has "));
    EXPECT_EQ(of("glTF" + GltfBuilder::word(1) + whole.substr(8)),
              "m.glb: error: glTF 1 is not supported; convert the file to glTF 2.0");
    EXPECT_THAT(of(whole.substr(0, 12) + GltfBuilder::word(0xFFFFFFF0) + whole.substr(16)),
                HasSubstr("a chunk of 4294967280 bytes where"));
    EXPECT_THAT(of(whole.substr(0, 16) + "NOPE" + whole.substr(20)),
                HasSubstr("the first chunk, and no other, must be JSON"));
    EXPECT_THAT(of("glTF" + GltfBuilder::word(2) + GltfBuilder::word(12)), HasSubstr("it has no JSON chunk"));
    EXPECT_EQ(of(whole + "rest"), "");
    EXPECT_THAT(notesText(), HasSubstr("warning: 4 bytes behind the end of the GLB data; ignored"));
}

TEST_F(GltfDamage, ReferencesMustBeFiles) {
    const GltfBuilder file = triangle();
    const std::string members = oneMesh(R"("attributes":{"POSITION":0})");
    EXPECT_EQ(failure(file.json(members, "gone%20.bin")),
              "m.gltf: error: buffers[0]: file not found: gone .bin");
    EXPECT_EQ(failure(file.json(members, "https://example.org/a.bin")),
              "m.gltf: error: buffers[0]: 'https://example.org/a.bin' is not a file; only files and data "
              "URIs are read");
    EXPECT_THAT(failure(file.json(members, "/dev/zero")), HasSubstr("file not found: /dev/zero"));
    EXPECT_EQ(failure(file.json(members, "")),
              "m.gltf: error: buffers[0]: has neither a uri nor the binary chunk of a GLB file");
    write("short.bin", file.binary().substr(0, 20));
    EXPECT_THAT(failure(file.json(members, "short.bin")),
                HasSubstr("bufferViews[0]: 36 bytes at 0 exceed the 20 bytes of buffers[0]"));
}

TEST_F(GltfDamage, FewBytesClaimNoMemory) {
    GltfBuilder file;
    file.declare(R"("componentType":5126,"count":4000000000,"type":"VEC3")");
    EXPECT_EQ(failure(file.embedded(oneMesh(R"("attributes":{"POSITION":0})"))),
              "m.gltf: error: accessors[0]: 4000000000 elements without a bufferView; the file is too small "
              "for that");
}

TEST_F(GltfDamage, MutationsAndTruncationsNeverCrash) {
    const std::string wholes[] = {everything().embedded(kEverything), everything().glb(kEverything)};
    std::mt19937 random(1);
    for (const std::string& whole : wholes) {
        for (std::size_t size = 0; size < whole.size(); size += 7) failure(whole.substr(0, size));
        for (int i = 0; i < 2000; ++i) {
            std::string text = whole;
            for (int k = 0; k < 3; ++k) {
                constexpr std::string_view kBytes = "0123456789-[]{},\":e.\xff ";
                text[random() % text.size()] = kBytes[random() % kBytes.size()];
            }
            failure(text);
        }
    }
}

}  // namespace
}  // namespace rayscope::test
