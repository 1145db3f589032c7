// Materials, textures, cameras and lights of glTF files.
#include <rayscope/image.h>

#include <cmath>

#include "gltf_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;

class GltfMaterials : public GltfFiles {
  protected:
    GltfMaterials() {
        RgbImage texels(2, 1);
        texels.at(0, 0) = Rgb(1, 0, 0);
        texels.at(1, 0) = Rgb(0, 0, 1);
        writeImage((folder_ / "two.png").string(), texels);
        file_.accessor(std::vector<float>{0, 0, 1, 0, 0, 1}, "VEC2");
        file_.accessor(std::vector<float>{0.5f, 0, 0.5f, 0, 0.5f, 1}, "VEC2");
    }

    /// A textured triangle with the only material of the file; `others` begins with a comma.
    SceneDescription readWith(const std::string& material, const std::string& others = "") {
        notes_.clear();
        return read(file_.embedded(
            oneMesh(R"("attributes":{"POSITION":0,"TEXCOORD_0":1,"TEXCOORD_1":2},"material":0)",
                    fmt::format(R"({},"materials":[{{{}}}]{})", kNode, material, others))));
    }
    Material materialOf(const std::string& material, const std::string& others = "") {
        return readWith(material, others).materials.at(0);
    }
    static std::string pbr(const std::string& members) {
        return R"("pbrMetallicRoughness":{)" + members + "}";
    }
    /// The members of a document with one texture, two.png.
    static std::string texture(const std::string& sampler = "") {
        return R"(,"images":[{"uri":"two.png"}],"textures":[{"source":0,"sampler":0}],"samplers":[{)" +
               sampler + "}]";
    }

    GltfBuilder file_ = triangle();
};

TEST_F(GltfMaterials, ConvertsMetalnessAndRoughness) {
    const Material plain =
        materialOf(R"("name":"paint",)" + pbr(R"("baseColorFactor":[0.5,0.25,0,1],"metallicFactor":0)"));
    EXPECT_EQ(plain.name, "paint");
    EXPECT_EQ(plain.kd, Rgb(0.5f, 0.25f, 0));
    EXPECT_EQ(plain.ks, Rgb(0.0f)) << "rough by default";
    EXPECT_EQ(plain.opacity, 1.0f);
    const Material mirror = materialOf(pbr(R"("baseColorFactor":[0.5,0.25,0,1],"roughnessFactor":0)"));
    EXPECT_EQ(mirror.kd, Rgb(0.0f));
    EXPECT_EQ(mirror.ks, Rgb(0.5f, 0.25f, 0)) << "a metal by default";
    EXPECT_EQ(mirror.shininess, 10000.0f);
    const Material glossy =
        materialOf(pbr(R"("baseColorFactor":[0.5,0.5,0.5,1],"metallicFactor":0,"roughnessFactor":0.5)"));
    EXPECT_FLOAT_EQ(glossy.ks.r, 0.25f * 0.04f);
    EXPECT_FLOAT_EQ(glossy.shininess, (2.0f / 0.0625f - 2.0f) / 4.0f);
    const Material absent = materialOf("");
    EXPECT_EQ(absent.name, "material 0");
    EXPECT_EQ(absent.kd, Rgb(1.0f));
    EXPECT_EQ(absent.ks, Rgb(0.0f));
    const auto scene = read(triangle().embedded(oneMesh(R"("attributes":{"POSITION":0})")));
    EXPECT_EQ(scene.materials.at(0).name, "default");
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(GltfMaterials, EnergyIsConserved) {
    for (const double metallic : {0.0, 0.5, 1.0})
        for (const double roughness : {0.0, 0.3, 1.0})
            for (const double base : {0.0, 0.5, 1.0}) {
                const Material m = materialOf(pbr(fmt::format(
                    R"("baseColorFactor":[{0},{0},{0},1],"metallicFactor":{1},"roughnessFactor":{2})", base,
                    metallic, roughness)));
                EXPECT_LE(m.kd.r + m.ks.r, 1.0f + 1e-6f) << base << " " << metallic << " " << roughness;
            }
}

TEST_F(GltfMaterials, ReadsAlphaModes) {
    const std::string color = pbr(R"("baseColorFactor":[1,1,1,0.25])");
    EXPECT_EQ(materialOf(color).opacity, 1.0f);
    EXPECT_EQ(materialOf(R"("alphaMode":"BLEND",)" + color).opacity, 0.25f);
    EXPECT_EQ(materialOf(R"("alphaMode":"MASK",)" + color).opacity, 0.0f);
    EXPECT_EQ(materialOf(R"("alphaMode":"MASK","alphaCutoff":0.25,)" + color).opacity, 1.0f);
    EXPECT_TRUE(notes_.empty()) << notesText();
    materialOf(R"("alphaMode":"BLEND",)" + pbr(R"("baseColorTexture":{"index":0})"), texture());
    EXPECT_THAT(notesText(), HasSubstr("note: transparent textures"));
}

TEST_F(GltfMaterials, ReadsTextures) {
    const auto scene = readWith(pbr(R"("metallicFactor":0,"baseColorTexture":{"index":0})"),
                                texture(R"("wrapS":33071,"wrapT":33071)"));
    ASSERT_TRUE(scene.materials[0].kdTexture) << notesText();
    EXPECT_EQ(scene.materials[0].kdTexture->image.at(0, 0), Rgb(1, 0, 0));
    EXPECT_EQ(scene.materials[0].kdTexture->wrap, TextureWrap::Clamp);
    EXPECT_EQ(meshOf(scene).texCoords[1], glm::vec2(1, 1));
    const Material tinted = materialOf(
        pbr(R"("metallicFactor":0,"baseColorFactor":[0.5,1,1,1],"baseColorTexture":{"index":0})"), texture());
    EXPECT_EQ(tinted.kdTexture->image.at(0, 0), Rgb(0.5f, 0, 0)) << "the factor multiplies the texels";
    EXPECT_EQ(tinted.kdTexture->wrap, TextureWrap::Repeat);
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(GltfMaterials, ReadsEmbeddedImages) {
    const std::string png = [&] {
        std::ifstream stream(folder_ / "two.png", std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(stream), {});
    }();
    const std::string use = pbr(R"("metallicFactor":0,"baseColorTexture":{"index":0})");
    const std::string uri = "data:image/png;base64," + GltfBuilder::base64(png);
    EXPECT_EQ(materialOf(use, fmt::format(R"(,"images":[{{"uri":"{}"}}],"textures":[{{"source":0}}])", uri))
                  .kdTexture->image.at(1, 0),
              Rgb(0, 0, 1));
    const int view = file_.view(png);
    EXPECT_EQ(
        materialOf(
            use, fmt::format(
                     R"(,"images":[{{"bufferView":{},"mimeType":"image/png"}}],"textures":[{{"source":0}}])",
                     view))
            .kdTexture->image.at(1, 0),
        Rgb(0, 0, 1));
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(GltfMaterials, TextureCoordinatesFollowTheMaterial) {
    const auto uvOf = [&](const std::string& members) {
        return meshOf(readWith(pbr(R"("metallicFactor":0,"baseColorTexture":{"index":0)" + members + "}"),
                               texture()))
            .texCoords.at(1);
    };
    EXPECT_EQ(uvOf(""), glm::vec2(1, 1));
    EXPECT_EQ(uvOf(R"(,"texCoord":1)"), glm::vec2(0.5f, 1));
    const auto transformed = [&](const std::string& members) {
        return uvOf(R"(,"extensions":{"KHR_texture_transform":{)" + members + "}}");
    };
    EXPECT_EQ(transformed(R"("offset":[0.25,0.5])"), glm::vec2(1.25f, 0.5f)) << "v of the format points down";
    EXPECT_EQ(transformed(R"("scale":[3,1])"), glm::vec2(3, 1));
    EXPECT_LT(glm::length(transformed(R"("rotation":1.5707963267948966)") - glm::vec2(0, 2)), 1e-6f)
        << "(1, 0) turns to (0, -1)";
    EXPECT_EQ(transformed(R"("texCoord":1)"), glm::vec2(0.5f, 1));
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(GltfMaterials, UnreadableImagesAreWarnings) {
    write("broken.png", "not an image");
    const std::string use =
        pbr(R"("metallicFactor":0,"baseColorFactor":[0,1,0,1],"baseColorTexture":{"index":0})");
    for (const char* image :
         {R"("uri":"gone.png")", R"("uri":"broken.png")", R"("uri":"http://example.org/a.png")",
          R"("uri":"data:image/png;base64,!!!!")", R"("name":"no source")", R"("bufferView":0)"}) {
        const Material material =
            materialOf(use, fmt::format(R"(,"images":[{{{}}}],"textures":[{{"source":0}}])", image));
        EXPECT_FALSE(material.kdTexture) << image;
        EXPECT_EQ(material.kd, Rgb(0, 1, 0)) << image;
        EXPECT_EQ(notes_.size(), 1u) << notesText();
        EXPECT_THAT(notesText(), HasSubstr("warning: texture 0: ")) << image;
    }
    materialOf(use, R"(,"textures":[{"extensions":{"KHR_texture_basisu":{"source":0}}}])");
    EXPECT_THAT(notesText(), HasSubstr("warning: textures without an image in a supported format"));
}

TEST_F(GltfMaterials, MetallicRoughnessTexturesAreAveraged) {
    RgbImage texels(2, 1);  // roughness is green, metalness is blue
    texels.at(0, 0) = Rgb(0, 0, 1);
    texels.at(1, 0) = Rgb(0, 0, 0);
    writeImage((folder_ / "mr.png").string(), texels);
    const Material material =
        materialOf(pbr(R"("baseColorFactor":[1,1,1,1],"metallicRoughnessTexture":{"index":0})"),
                   R"(,"images":[{"uri":"mr.png"}],"textures":[{"source":0}])");
    EXPECT_FLOAT_EQ(material.kd.r, 0.5f) << "metalness 0.5, roughness 0";
    EXPECT_THAT(notesText(), HasSubstr("note: textures of metalness and roughness; their means are used"));
}

TEST_F(GltfMaterials, FeaturesThatAreLeftOutAreNotedOnce) {
    const std::string textured = pbr(R"("metallicFactor":0,"baseColorTexture":{"index":0})");
    const struct {
        std::string material, others, note;
    } cases[] = {
        {R"("normalTexture":{"index":0})", "", "normal maps; ignored"},
        {R"("occlusionTexture":{"index":0})", "", "occlusion maps; ignored"},
        {R"("emissiveFactor":[1,0,0])", "", "materials that emit light"},
        {R"("pbrMetallicRoughness":{"baseColorFactor":[2,0,0,1]})", "", "not between 0 and 1; clamped"},
        {"", R"(,"extensionsUsed":["KHR_materials_sheen"])",
         "the extension KHR_materials_sheen is not supported"},
        {"", R"(,"extensionsRequired":["KHR_materials_unlit"],"extensionsUsed":["KHR_materials_unlit"])",
         "KHR_materials_unlit is not supported"},
        {textured, texture(R"("wrapS":33648)"), "textures that repeat mirrored"},
        {textured, texture(R"("wrapS":33071)"), "textures that clamp in one direction only"},
        {textured, texture(R"("magFilter":9728)"), "nearest-neighbour filter"},
        {pbr(R"("roughnessFactor":0,"baseColorTexture":{"index":0})"), texture(), "textured metals"},
        {"", R"(,"animations":[{}])", "animations; ignored"}};
    for (const auto& [material, others, note] : cases) {
        readWith(material, others);
        EXPECT_EQ(notes_.size(), 1u) << notesText();
        EXPECT_THAT(notesText(), HasSubstr(note));
    }
}

TEST_F(GltfMaterials, ReadsSpecularGlossiness) {
    const Material material = materialOf(
        R"("extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.5,0,0,1],"specularFactor":[0.25,0.25,0.25],"glossinessFactor":1}})",
        R"(,"extensionsUsed":["KHR_materials_pbrSpecularGlossiness"])");
    EXPECT_EQ(material.kd, Rgb(0.5f, 0, 0));
    EXPECT_EQ(material.ks, Rgb(0.25f));
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(GltfMaterials, ReadsCameras) {
    const std::string others =
        R"("cameras":[{"type":"perspective","name":"a","perspective":{"yfov":1,"znear":0.1}},{"type":"orthographic"}],)"
        R"("nodes":[{"mesh":0},{"camera":0,"translation":[0,0,5]},{"name":"a","camera":0,"translation":[0.5,0.5,5],"rotation":[0,0,0.7071067811865476,0.7071067811865476],"scale":[3,3,3]},{"camera":1}],"scenes":[{"nodes":[0,1,2,3]}])";
    const auto scene = read(triangle().embedded(oneMesh(R"("attributes":{"POSITION":0})", others)));
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].name, "a");
    EXPECT_EQ(scene.cameras[1].name, "a 2");
    EXPECT_EQ(scene.cameras[0].lookFrom, glm::vec3(0, 0, 5));
    EXPECT_EQ(scene.cameras[0].lookAt, glm::vec3(0, 0, 0))
        << "along -z, as far away as the centre of the triangle";
    EXPECT_FLOAT_EQ(scene.cameras[0].fov, 57.29578f);
    EXPECT_LT(glm::length(scene.cameras[1].up - glm::vec3(-1, 0, 0)), 1e-6f);
    EXPECT_EQ(notesText(), folder_.string() + "/m.gltf: note: orthographic cameras; left out\n");
}

TEST_F(GltfMaterials, ReadsLights) {
    const std::string others =
        R"("extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","color":[1,0.5,0],"intensity":6.283185307179586},{"type":"directional"},{"type":"spot","spot":{}}]}},)"
        R"("nodes":[{"mesh":0},{"translation":[0,3,0],"extensions":{"KHR_lights_punctual":{"light":0}}},{"extensions":{"KHR_lights_punctual":{"light":1}}},{"extensions":{"KHR_lights_punctual":{"light":2}}}],"scenes":[{"nodes":[0,1,2,3]}])";
    const auto scene = read(triangle().embedded(oneMesh(R"("attributes":{"POSITION":0})", others)));
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[0], (Light{PointLight{glm::vec3(0, 3, 0), Rgb(2, 1, 0)}, Falloff::InverseSquare}));
    const auto& distant = std::get<PointLight>(scene.lights[1].shape);
    EXPECT_EQ(scene.lights[1].falloff, Falloff::None);
    EXPECT_GT(distant.position.z, 1000.0f) << "the light shines along -z";
    EXPECT_FLOAT_EQ(distant.position.x, 0.5f);
    EXPECT_THAT(notesText(), HasSubstr("warning: spot lights; left out"));
    EXPECT_THAT(notesText(), HasSubstr("note: directional lights; distant point lights are used"));
}

}  // namespace
}  // namespace rayscope::test
