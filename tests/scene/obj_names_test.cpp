// Names of materials and of material files.
#include <fmt/format.h>

#include "obj_files.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;

class ObjNames : public ObjFiles {
  protected:
    /// Kd of a triangle with these mtllib and usemtl statements.
    Rgb kdWith(std::string_view mtllib, std::string_view usemtl = "red") {
        return read(fmt::format("mtllib {}\n{}usemtl {}\nf 1 2 3\n", mtllib, kTriangle, usemtl))
            .materials.at(0)
            .kd;
    }
};

constexpr Rgb kRed(1, 0, 0), kGreen(0, 1, 0), kDefault(0.8f);
constexpr std::string_view kRedMtl = "newmtl red\nKd 1 0 0\n";

TEST_F(ObjNames, MaterialFilesAreFoundInAllSpellings) {
    write("a.mtl", kRedMtl);
    write("a b.mtl", kRedMtl);
    write("dir/c.mtl", kRedMtl);
    write("no suffix", kRedMtl);
    write("x.txt", kRedMtl);
    for (const std::string_view name :
         {"a.mtl", "\ta.mtl  ", "./a.mtl", ".\\a.mtl", "\"a.mtl\"", "'a.mtl'", "a.mtl # comment", "a b.mtl",
          "a\\ b.mtl", "\"a b.mtl\"", "\"a b.mtl\" # comment", "dir/c.mtl", "dir\\c.mtl", "no suffix",
          "x.txt", "\\\n a.mtl"}) {
        EXPECT_EQ(kdWith(name), kRed) << name;
        EXPECT_EQ(notesText(), "") << name;
    }
}

TEST_F(ObjNames, OneStatementMayNameSeveralFiles) {
    write("b g.mtl", "newmtl green\nKd 0 1 0\n");
    write("b h.mtl", kRedMtl);
    write("c.mtl", kRedMtl);
    write("d.MTL", "newmtl green\nKd 0 1 0\n");
    for (const std::string_view names :
         {"b g.mtl b h.mtl", "\"b g.mtl\" \"b h.mtl\"", "b g.mtl c.mtl", "d.MTL c.mtl", "c.mtl d.MTL",
          "b\\ g.mtl b\\ h.mtl", "b g.mtl c.mtl # comment", "c.mtl\nmtllib d.MTL"}) {
        EXPECT_EQ(kdWith(names, "red"), kRed) << names;
        EXPECT_EQ(kdWith(names, "green"), kGreen) << names;
        EXPECT_EQ(notesText(), "") << names;
    }
}

TEST_F(ObjNames, FilesElsewhereAreFoundBesideTheObj) {
    write("a.mtl", kRedMtl);
    for (const std::string_view name :
         {"C:\\models\\a.mtl", "/nowhere/a.mtl", "materials/a.mtl", "A.MTL", "\"x y/a.mtl\""}) {
        EXPECT_EQ(kdWith(name), kRed) << name;
        EXPECT_THAT(notesText(), HasSubstr("mesh.obj:1: warning: material file '")) << name;
        EXPECT_THAT(notesText(), HasSubstr("' is not found; ")) << name;
    }
}

TEST_F(ObjNames, FilesWithNamesInWindows1252) {
    for (const std::string& name : {std::string("caf\xe9.mtl"), std::string("\x80 5.mtl")}) {
        write(name, kRedMtl);
        EXPECT_EQ(kdWith(name), kRed) << name;
        EXPECT_EQ(notesText().find("not found"), std::string::npos) << notesText();
    }
    write("caf\xc3\xa9.mtl", kRedMtl);
    EXPECT_EQ(kdWith("caf\xc3\xa9.mtl"), kRed);
}

TEST_F(ObjNames, MissingFilesAndMaterialsAreWarnings) {
    EXPECT_EQ(kdWith("gone.mtl"), kDefault);
    EXPECT_EQ(notesText(),
              "mesh.obj:1: warning: material file 'gone.mtl' is not found; default materials are used\n");
    write("a.mtl", kRedMtl);
    read("mtllib gone.mtl\nmtllib a.mtl\n" + kTriangle + "usemtl red\nf 1 2 3\n");
    EXPECT_EQ(notesText(),
              "mesh.obj:1: warning: material file 'gone.mtl' is not found; no material of it is used\n");
    EXPECT_EQ(kdWith(""), kDefault);
    EXPECT_THAT(notesText(), HasSubstr("mesh.obj:1: warning: mtllib without a file name; ignored\n"));
    EXPECT_EQ(kdWith("a.mtl", "blue"), kDefault);
    EXPECT_EQ(notesText(), "mesh.obj:5: warning: undefined material 'blue'; a default material is used\n");
    read("mtllib a.mtl\n" + kTriangle + "usemtl x\nf 1 2 3\nusemtl y\nf 1 2 3\nusemtl z\nf 1 2 3\n");
    EXPECT_EQ(notesText(),
              "mesh.obj:5: warning: undefined material 'x' and 2 more; a default material is used\n");
}

TEST_F(ObjNames, MaterialsAreFoundInAllSpellings) {
    const std::tuple<std::string_view, std::string_view, std::string_view> names[] = {
        {"red", "red", "red"},
        {"red", "red  \t", "red"},
        {" red ", "red", "red"},
        {"red", "red # comment", "red"},
        {"red # comment", "red", "red"},
        {"red # one", "red # two", "red"},
        {"red paint", "red paint", "red paint"},
        {"\"red paint\"", "red paint", "red paint"},
        {"red paint", "\"red paint\"", "red paint"},
        {"", "", "unnamed"},
        {"red#1", "red#1", "red#1"},
        {"R\xc3\xb6t", "R\xc3\xb6t", "R\xc3\xb6t"},
        {"R\xf6t", "R\xf6t", "R\xc3\xb6t"},
        {"R\xc3\xb6t", "R\xf6t", "R\xc3\xb6t"},
        {"Kd", "Kd", "Kd"},
    };
    for (const auto& [defined, used, shown] : names) {
        SCOPED_TRACE(fmt::format("newmtl {} / usemtl {}", defined, used));
        write("m.mtl", fmt::format("newmtl other\nKd 0 0 1\nnewmtl {}\nKd 1 0 0\n", defined));
        const SceneDescription scene =
            read(fmt::format("mtllib m.mtl\n{}usemtl {}\nf 1 2 3\n", kTriangle, used));
        EXPECT_EQ(scene.materials.at(0).kd, kRed);
        EXPECT_EQ(scene.materials.at(0).name, shown);
        EXPECT_EQ(notesText().find("warning"), std::string::npos) << notesText();
    }
}

TEST_F(ObjNames, NamesWithHashesAreToldApart) {
    write("m.mtl", "newmtl Material #25\nKd 1 0 0\nnewmtl Material #26\nKd 0 1 0\n");
    EXPECT_EQ(kdWith("m.mtl", "Material #25"), kRed);
    EXPECT_EQ(kdWith("m.mtl", "Material #26"), kGreen);
    EXPECT_EQ(notesText(), "");
}

TEST_F(ObjNames, NamesInAnotherCaseAreWarnings) {
    write("m.mtl", kRedMtl);
    EXPECT_EQ(kdWith("m.mtl", "RED"), kRed);
    EXPECT_EQ(
        notesText(),
        "mesh.obj:5: warning: materials (usemtl) whose names differ from those of the MTL file in upper and "
        "lower case\n");
    write("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl RED\nKd 0 1 0\n");
    EXPECT_EQ(kdWith("m.mtl", "RED"), kGreen);
    EXPECT_EQ(notesText(), "");
}

TEST_F(ObjNames, LaterDefinitionsReplaceEarlierOnes) {
    write("m.mtl", "newmtl red\nKd 0 1 0\nNs 5\nnewmtl x\nKd 0 0 1\nnewmtl red\nKd 1 0 0\n");
    const Material red = read("mtllib m.mtl\n" + kTriangle + "usemtl red\nf 1 2 3\n").materials.at(0);
    EXPECT_EQ(red.kd, kRed);
    EXPECT_EQ(red.shininess, 5.0f) << "statements that are not repeated stay";
    EXPECT_EQ(notesText(),
              "m.mtl:6: warning: materials with the name of an earlier one; the later statements replace the "
              "earlier ones\n");
    write("n.mtl", "newmtl red\nKd 0 1 0\n");
    EXPECT_EQ(kdWith("m.mtl\nmtllib n.mtl"), kGreen);
    EXPECT_THAT(notesText(),
                HasSubstr("warning: materials in several MTL files; those of the last file are used"));
    EXPECT_EQ(kdWith("m.mtl\nmtllib m.mtl"), kRed) << "the same file twice";
}

TEST_F(ObjNames, MaterialsOfFacesBeforeAnyUsemtl) {
    write("m.mtl", "newmtl a\nKd 1 0 0\nnewmtl\nKd 0 1 0\n");
    const SceneDescription scene = read("mtllib m.mtl\n" + kTriangle +
                                        "f 1 2 3\nusemtl a\nf 1 2 3\nusemtl\nf 1 2 3\nusemtl a\nf 1 3 2\n");
    ASSERT_EQ(scene.materials.size(), 3u);
    EXPECT_EQ(scene.materials[0].name, "default");
    EXPECT_EQ(scene.materials[0].kd, kDefault) << "not the unnamed material";
    EXPECT_EQ(scene.materials[2].kd, kGreen);
    EXPECT_EQ(meshOf(scene).materialSlots, (std::vector<std::uint16_t>{0, 1, 2, 1}));
}

TEST_F(ObjNames, GroupsAndObjectsMayHaveAnyName) {
    const SceneDescription scene = read("o\ng\no a b # c\ng x y z\n" + kTriangle + "g \xff\nf 1 2 3\n");
    EXPECT_EQ(meshOf(scene).triangles.size(), 1u);
    EXPECT_EQ(notesText(), "mesh.obj: note: bytes that are not UTF-8; read as Windows-1252 (Latin-1)\n");
}

}  // namespace
}  // namespace rayscope::test
