// Well-formed OBJ files, compared with tinyobjloader.
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <random>

#include "obj_files.h"

namespace rayscope::test {
namespace {

class ObjOracle : public ObjFiles {
  protected:
    /// A file with all forms of corners, polygons, and several materials; the values have few digits, since
    /// tinyobjloader does not round correctly.
    static std::string randomFile(unsigned seed) {
        std::mt19937 random(seed);
        const auto below = [&](int count) {
            return static_cast<int>(random() % static_cast<unsigned>(count));
        };
        std::string text = "mtllib m.mtl\n";
        for (int i = 0; i < 60; ++i) {
            text += fmt::format("v {} {} {}\n", below(1000) / 8.0, -below(1000) / 8.0, below(1000) / 8.0);
            text += fmt::format("vt {} {}\n", below(64) / 64.0, below(64) / 64.0);
            text += fmt::format("vn {} {} {}\n", below(9) - 4, below(9) - 4, below(9) - 4);
        }
        for (int face = 0; face < 100; ++face) {
            if (face % 7 == 0) text += fmt::format("usemtl m{}\n", below(4));
            if (face % 9 == 0) text += fmt::format("g group{}\n# comment\n", face);
            text += "f";
            const int form = below(4);
            for (int corner = 0; corner < 3; ++corner) {
                const auto index = [&] { return below(2) == 0 ? below(60) + 1 : -below(60) - 1; };
                text += fmt::format(" {}", index());
                if (form == 1) text += fmt::format("/{}", index());
                if (form == 2) text += fmt::format("//{}", index());
                if (form == 3) text += fmt::format("/{}/{}", index(), index());
            }
            text += "\n";
        }
        return text;
    }

    /// Compares a corner of a triangle with that of tinyobjloader.
    static void expectSameCorner(const MeshData& mesh, std::uint32_t vertex,
                                 const tinyobj::attrib_t& elements, const tinyobj::index_t& index) {
        const auto vectorOf = [](const std::vector<tinyobj::real_t>& list, int element) {
            const std::size_t first = 3 * static_cast<std::size_t>(element);
            return glm::vec3(list[first], list[first + 1], list[first + 2]);
        };
        EXPECT_EQ(mesh.positions[vertex], vectorOf(elements.vertices, index.vertex_index));
        if (index.normal_index >= 0) {
            EXPECT_EQ(mesh.normals[vertex], vectorOf(elements.normals, index.normal_index));
        }
        if (index.texcoord_index >= 0) {
            const std::size_t first = 2 * static_cast<std::size_t>(index.texcoord_index);
            EXPECT_EQ(mesh.texCoords[vertex],
                      glm::vec2(elements.texcoords[first], elements.texcoords[first + 1]));
        }
    }

    static void expectSameMaterial(const Material& material, const tinyobj::material_t& expected) {
        EXPECT_EQ(material.name, expected.name);
        EXPECT_EQ(material.kd, Rgb(expected.diffuse[0], expected.diffuse[1], expected.diffuse[2]));
        EXPECT_EQ(material.ks, Rgb(expected.specular[0], expected.specular[1], expected.specular[2]));
        EXPECT_EQ(material.opacity, expected.dissolve);
        EXPECT_EQ(material.shininess, expected.shininess);
    }
};

TEST_F(ObjOracle, AgreesWithTinyobjloader) {
    write("m.mtl",
          "newmtl m0\nKd 0.5 0.25 0.125\nd 0.5\nnewmtl m1\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 12\nillum 2\n"
          "newmtl m2\nKd 0 0 1\nTr 0.25\nnewmtl m3\nKd 0 1 1\n");
    for (unsigned seed = 0; seed < 20; ++seed) {
        const std::string path = write("mesh.obj", randomFile(seed));
        const SceneDescription scene = load(path);
        const MeshData& mesh = meshOf(scene);
        tinyobj::ObjReader reader;
        ASSERT_TRUE(reader.ParseFromFile(path)) << reader.Error();
        std::size_t triangle = 0;
        for (const tinyobj::shape_t& shape : reader.GetShapes())
            for (std::size_t face = 0; face < shape.mesh.num_face_vertices.size(); ++face, ++triangle) {
                ASSERT_LT(triangle, mesh.triangles.size());
                for (std::size_t i = 0; i < 3; ++i)
                    expectSameCorner(mesh, mesh.triangles[triangle][static_cast<int>(i)], reader.GetAttrib(),
                                     shape.mesh.indices[3 * face + i]);
                expectSameMaterial(
                    scene.materials[mesh.materialSlots[triangle]],
                    reader.GetMaterials()[static_cast<std::size_t>(shape.mesh.material_ids[face])]);
            }
        EXPECT_EQ(triangle, mesh.triangles.size());
    }
}

}  // namespace
}  // namespace rayscope::test
