// OBJ and MTL files as programs write them.
#include "obj_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;

class ObjReader : public ObjFiles {};

TEST_F(ObjReader, BareMeshGetsACameraAndALight) {
    const auto scene = read(kTriangle + "f 1 2 3\n");
    EXPECT_EQ(meshOf(scene).triangles, std::vector<glm::uvec3>{glm::uvec3(0, 1, 2)});
    ASSERT_EQ(scene.cameras.size(), 1u);
    ASSERT_EQ(scene.lights.size(), 1u);
    const CameraDescription& camera = scene.cameras[0];
    const glm::vec3 toLight = std::get<PointLight>(scene.lights[0].shape).position - camera.lookFrom;
    EXPECT_LT(toLight.x, 0.0f) << "left of a camera that looks along -z";
    EXPECT_GT(toLight.y, 0.0f) << "above it";
    EXPECT_TRUE(notes_.empty()) << notesText();
}

TEST_F(ObjReader, ReadsMaterials) {
    write("lib/a b.mtl",
          "newmtl red paint\nKd 0.5 0.1 0.1\nKs 0.25 0.25 0.25\nNs 30\nTr 0.25\nillum 3\nKa 1 1 1\nmap_bump "
          "x.png\n"
          "newmtl blue\nKd 0 0 1\nd 0.5\nTr 0.75\n");
    const auto scene = read("mtllib lib\\a b.mtl\n" + kTriangle +
                            "usemtl red paint  \nf 1 2 3\nusemtl blue\nf 1 2 3\nf 1 3 2\n");
    ASSERT_EQ(scene.materials.size(), 2u);
    const Material& red = scene.materials[0];
    EXPECT_EQ(red.name, "red paint");
    EXPECT_EQ(red.kd, Rgb(0.5f, 0.1f, 0.1f));
    EXPECT_EQ(red.ks, Rgb(0.25f));
    EXPECT_EQ(red.shininess, 30.0f);
    EXPECT_EQ(red.opacity, 0.75f);
    EXPECT_EQ(red.illum, 3);
    EXPECT_EQ(scene.materials[1].opacity, 0.5f) << "d overrides Tr";
    EXPECT_EQ(meshOf(scene).materialSlots, (std::vector<std::uint16_t>{0, 1, 1}));
    EXPECT_THAT(notesText(), HasSubstr("d and Tr that contradict each other; d is used"));
    EXPECT_THAT(notesText(), HasSubstr("ignored statements: Ka, map_bump"));
}

TEST_F(ObjReader, TrianglesWithATextureButWithoutCoordinatesAreWarnings) {
    rayscope::writeImage((folder_ / "t.pfm").string(), RgbImage(2, 1));
    write("m.mtl", "newmtl a\nKd 1 1 1\nmap_Kd t.pfm\nnewmtl b\nKd 1 1 1\n");
    const std::string begin = "mtllib m.mtl\n" + kTriangle + "vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n";
    read(begin + "f 1 2 3\nf 1/1 2 3/1\n");
    EXPECT_EQ(notesText(),
              "mesh.obj: warning: triangles with a texture but without texture coordinates; the texture is "
              "sampled at (0, 0) (2 times)\n");
    read(begin + "usemtl b\nf 1 2 3\n");
    EXPECT_EQ(notesText(), "");
}

}  // namespace
}  // namespace rayscope::test
