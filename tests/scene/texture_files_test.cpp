// Image files as textures: what their readers report reaches the notes of the scene.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "scene_files.h"

namespace rayscope {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class TextureFiles : public test::SceneFiles {
  protected:
    std::string sceneWith(const std::string& texture) {
        return write("a.toml", "version = 1\n[material.a]\nkd_texture = \"" + texture + "\"\n");
    }
};

TEST_F(TextureFiles, OdditiesOfTexturesAreReportedOnce) {
    const std::string image = write("t.pgm", "P5\n1 1\n255\naP5\n1 1\n255\nb");
    load(sceneWith("t.pgm"));
    const std::string line = image + ": warning: a file with several images: only the first is read\n";
    EXPECT_THAT(notesText(), HasSubstr(line));
    EXPECT_EQ(notesText().find(line), notesText().rfind(line));
}

TEST_F(TextureFiles, FormatsThatAreNotReadAreNamed) {
    write("t.png", "GIF89a");
    EXPECT_EQ(errorOf(sceneWith("t.png")), "t.png: error: is a GIF image; convert it to PNG or EXR");
    write("t.mtl", "newmtl a\nKd 0.5 0.5 0.5\nmap_Kd t.png\n");
    load(write("a.obj", "mtllib t.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    EXPECT_THAT(notesText(), AllOf(HasSubstr("is a GIF image"), HasSubstr("Kd is used")));
}

TEST_F(TextureFiles, PipesAreNotWaitedFor) {
    ASSERT_EQ(::mkfifo((folder_ / "t.png").c_str(), 0600), 0);
    write("t.mtl", "newmtl a\nmap_Kd t.png\n");
    load(write("a.obj", "mtllib t.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    EXPECT_THAT(notesText(), HasSubstr("is a pipe or device, not a regular file"));
}

}  // namespace
}  // namespace rayscope
