// Lines, encodings and statements of OBJ files, and files that are something else.
#include <fmt/format.h>
#include <sys/stat.h>

#include "obj_files.h"

namespace rayscope::test {
namespace {

using namespace std::string_literals;
using ::testing::HasSubstr;

class ObjLines : public ObjFiles {
  protected:
    /// Whether the file is the triangle of kTriangle.
    void expectTriangle(std::string_view text) {
        const SceneDescription scene = read(text);
        ASSERT_EQ(meshOf(scene).triangles, std::vector<glm::uvec3>{glm::uvec3(0, 1, 2)});
        EXPECT_EQ(meshOf(scene).positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    }
    static std::string replaced(std::string text, std::string_view from, std::string_view to) {
        for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
        return text;
    }
};

const std::string kFile = "# comment\n" + kTriangle + "f 1 2 3\n";

TEST_F(ObjLines, AllLineEndsAreRead) {
    for (const std::string_view end : {"\n", "\r\n", "\r", "\n\n", " \t\r\n", "\n \t\n\r\n"}) {
        expectTriangle(replaced(kFile, "\n", end));
        EXPECT_EQ(notesText(), "");
    }
    expectTriangle("# a\r\n# b\rv 0 0 0\nv 1 0 0\r\nv 0 1 0\rf 1 2 3");
    EXPECT_EQ(failure("v 0 0 0\rv 1 0 0\rv x 1 0\r"), "mesh.obj:3:3: error: expected a number, got 'x'");
}

TEST_F(ObjLines, TheLastLineNeedsNoEnd) { expectTriangle(kTriangle + "f 1 2 3"); }

TEST_F(ObjLines, BackslashesContinueLines) {
    for (const std::string_view face :
         {"f 1 2 \\\n3\n", "f 1 2 \\\r\n3\r\n", "f 1 2 \\  \t\n3\n", "f \\\n1 \\\n2 \\\n3\n", "f 1 2 3 \\\n",
          "f 1 2 3 \\", "f 1 2 3\\\n\n", "f 1 2\\\n 3", "f 1 2 \\\r3"})
        expectTriangle(kTriangle + std::string(face));
    expectTriangle("# no \\\nv 0 0 0 # no \\\nv 1 0 0\nv 0 1 \\\n 0\nf 1 2 3\n");
    expectTriangle("\\\n\n\\\n \\\n\n" + kFile + "\\\n\\");
    EXPECT_EQ(notesText(), "");
    EXPECT_EQ(failure(kTriangle + "f 1 \\\n 2 \\\n  x\n"), "mesh.obj:6:3: error: expected an index, got 'x'");
    EXPECT_EQ(failure(kTriangle + " f x \\\n 2 3\n"), "mesh.obj:4:4: error: expected an index, got 'x'");
}

TEST_F(ObjLines, CommentsAndBlanksAreIgnored) {
    expectTriangle(
        "# a path C:\\\nv 0 0 0 # origin\r\n\tv\t1  0 0\n  v 0 1 0#\n\t# x\n#f 9 9 9\nf 1 2 3 # 4 5\n");
    EXPECT_EQ(notesText(), "");
}

TEST_F(ObjLines, EncodingsAreRead) {
    const auto utf16 = [](std::string_view text, bool isBig, bool hasMark) {
        std::string bytes = hasMark ? isBig ? "\xfe\xff" : "\xff\xfe" : "";
        for (const char c : text) bytes += isBig ? "\0"s + c : std::string(1, c) + "\0"s;
        return bytes;
    };
    expectTriangle("\xef\xbb\xbf" + kFile);
    EXPECT_EQ(notesText(), "");
    for (const bool isBig : {false, true})
        for (const bool hasMark : {false, true}) {
            expectTriangle(utf16(kFile, isBig, hasMark));
            EXPECT_EQ(notesText(), "mesh.obj: note: the text is UTF-16\n");
        }
    expectTriangle("# \xa9 M\xfcller\n" + kFile);
    EXPECT_EQ(notesText(), "mesh.obj: note: bytes that are not UTF-8; read as Windows-1252 (Latin-1)\n");
    expectTriangle("# © Müller\n" + kFile);
    EXPECT_EQ(notesText(), "");
    EXPECT_THAT(failure("\xff\xfe\0\0v\0\0\0"s), ::testing::HasSubstr("it is text in UTF-32"));
}

TEST_F(ObjLines, ZeroBytesAreBlanks) {
    expectTriangle(kFile + std::string(500, '#') + std::string(10, '\0'));
    EXPECT_EQ(notesText(), "mesh.obj: warning: zero bytes in the text; read as blanks\n");
}

TEST_F(ObjLines, OtherFilesAreNamed) {
    const std::pair<std::string, std::string_view> files[] = {
        {"\x1f\x8b\x08\x00\x00"s, "is compressed with gzip; decompress it first (gunzip)"},
        {"PK\x03\x04zip"s, "is a ZIP archive; extract it first"},
        {"\x28\xb5\x2f\xfd"s, "is compressed with zstd; decompress it first (unzstd)"},
        {"\xfd\x37zXZ"s, "is compressed with xz; decompress it first (unxz)"},
        {"BZh91AY"s, "is compressed with bzip2; decompress it first (bunzip2)"},
        {"7z\xbc\xaf\x27\x1c"s, "is a 7z archive; extract it first"},
        {"Rar!\x1a\x07"s, "is a RAR archive; extract it first"},
        {"<!DOCTYPE html>\n<html>"s, "is a web page"},
        {"\n <HTML><body>"s, "is XML or a web page"},
        {"<?xml version=\"1.0\"?>"s, "is an XML file"},
        {"version https://git-lfs.github.com/spec/v1\n"s,
         "is a pointer of Git LFS; fetch the file itself with git lfs pull"},
        {"ply\nformat ascii 1.0\n"s, "is a PLY file; rename it to .ply"},
        {"solid cube\n facet normal 0 0 1\n"s, "is an STL file; rename it to .stl"},
        {"glTF\x02\0\0\0"s, "is a binary glTF file; rename it to .glb"},
        {"{ \"asset\": {} }"s, "is a glTF file; rename it to .gltf"},
        {"{ \"a\": 1 }"s, "is JSON"},
        {"Kaydara FBX Binary  \0"s, "is an FBX file"},
        {"BLENDER-v300"s, "is a Blender file"},
        {"\x89PNG\r\n\x1a\n"s, "is a PNG image"},
        {"\x64\x86\x03\0\0"s, "is an object file of a compiler (machine code)"},
        {std::string(80, '\0') + "\x0c\0\0\0"s, "is binary, not text"},
    };
    for (const auto& [bytes, what] : files)
        EXPECT_EQ(failure(bytes), fmt::format("mesh.obj: error: not a file in OBJ format: it {}", what));
}

TEST_F(ObjLines, PipesAndFoldersAreRefused) {
    const std::string pipe = (folder_ / "pipe.obj").string();
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(errorOf(pipe), "pipe.obj: error: is a pipe or device, not a regular file");
    std::filesystem::create_directories(folder_ / "folder.obj");
    EXPECT_EQ(errorOf((folder_ / "folder.obj").string()), "folder.obj: error: is a folder, not a file");
}

TEST_F(ObjLines, FilesWithoutFacesNameWhatTheyHave) {
    const std::string none = "mesh.obj: error: the file has no faces (lines 'f …')";
    EXPECT_EQ(failure(""), none);
    EXPECT_EQ(failure("# only a comment\n"), none);
    EXPECT_EQ(failure(kTriangle), none + "; it has only 3 vertices");
    EXPECT_EQ(failure(kTriangle + "l 1 2\nl 2 3\n"), none + "; it has 2 line elements (l)");
    EXPECT_EQ(failure(kTriangle + "p 1 2 3\n"), none + "; it has 1 point elements (p)");
    EXPECT_EQ(failure(kTriangle + "cstype bspline\ndeg 3\nsurf 0 1 0 1 1 2 3\nparm u 0 1\nend\n"),
              none + "; its free-form curves and surfaces (surf in line 4) are not read, export polygons");
    EXPECT_EQ(failure("hello\nworld wide\n"), none + "; none of its lines is a statement of an OBJ file");
}

TEST_F(ObjLines, StatementsWithoutTrianglesAreNotedOnce) {
    read(kTriangle + "o a\ng b c\nl 1 2\nl 2 3\np 1\ncurv2 1 2\nend\nf 1 2 3\nbevel on\nlod 3\nbevel off\n");
    EXPECT_EQ(
        notesText(),
        "mesh.obj:6: note: line elements (l); ignored (2 times, first here)\n"
        "mesh.obj:8: note: point elements (p); ignored\n"
        "mesh.obj:9: warning: statements of free-form curves and surfaces; ignored (2 times, first here)\n"
        "mesh.obj: note: ignored statements: bevel, lod\n");
}

TEST_F(ObjLines, SmoothingGroupsAreNotedWhereNormalsAreMissing) {
    read(kTriangle + "s 1\nf 1 2 3\n");
    EXPECT_EQ(
        notesText(),
        "mesh.obj:4: note: smoothing groups (s) are ignored: the file has no normals (vn), so its faces are "
        "flat\n");
    read(kTriangle + "vn 0 0 1\ns 1\nf 1//1 2//1 3//1\n");
    EXPECT_EQ(notesText(), "");
    read(kTriangle + "s off\ns 0\nf 1 2 3\n");
    EXPECT_EQ(notesText(), "");
}

TEST_F(ObjLines, OnlyWordsThatLookLikeKeywordsAreQuoted) {
    read(kTriangle + "f 1 2 3\nroot:$y$j9T$secret:19000:0\n\x1b[31mred\n=== 1\n");
    EXPECT_EQ(notesText(),
              "mesh.obj:5: warning: lines that are no OBJ statements; ignored (3 times, first here)\n");
    std::string many = kTriangle + "f 1 2 3\n";
    for (char c = 'a'; c < 'z'; ++c) many += fmt::format("word{} 1\n", c);
    read(many + std::string(100000, 'w') + "\n");
    EXPECT_THAT(notesText(), HasSubstr("ignored statements: worda, wordb"));
    EXPECT_THAT(notesText(), HasSubstr("wordl and others\n"));
    EXPECT_LT(notesText().size(), 200u);
    read(kTriangle + "f 1 2 3\n" + std::string(100000, 'w') + "\n");
    EXPECT_EQ(notesText(), "mesh.obj: note: ignored statements: " + std::string(29, 'w') + "___\n");
}

TEST_F(ObjLines, LoadingReportsProgressAndStops) {
    std::string text = kTriangle;
    for (int i = 0; i < 20000; ++i) text += "f 1 2 3\n";
    const std::string path = write("mesh.obj", text);
    std::vector<double> fractions;
    LoadControl control;
    control.progress = [&](const std::string& step, double fraction) {
        if (step == "parsing mesh.obj") fractions.push_back(fraction);
    };
    loadScene(path, notes_, control);
    EXPECT_GT(fractions.size(), 100u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_GT(fractions.back(), 0.99);

    std::stop_source stop;
    std::size_t calls = 0;
    control.stop = stop.get_token();
    control.progress = [&](const std::string&, double) {
        if (++calls == 10) stop.request_stop();
    };
    EXPECT_THROW(loadScene(path, notes_, control), Stopped);
    EXPECT_EQ(calls, 10u);
}

TEST_F(ObjLines, ReadsThousandsOfVertices) {
    std::string text;
    for (int i = 0; i < 2000; ++i) text += fmt::format("v {} {} 0\n", i % 50, i / 50);
    for (int i = 0; i + 51 < 2000; ++i) text += fmt::format("f {} {} {}\n", i + 1, i + 2, i + 52);
    const SceneDescription scene = read(text);
    EXPECT_EQ(meshOf(scene).triangles.size(), 1949u);
    for (const glm::uvec3& t : meshOf(scene).triangles)
        EXPECT_NE(meshOf(scene).positions[t.y], meshOf(scene).positions[t.x]);
    EXPECT_EQ(meshOf(scene).positions.size(), 2000u);
}

}  // namespace
}  // namespace rayscope::test
