// map_Kd: names of files and options.
#include <fmt/format.h>
#include <rayscope/image.h>
#include <sys/stat.h>

#include "obj_files.h"
#include "scene/mesh_files/obj/mtl_texture.h"

namespace rayscope::test {
namespace {

using ::testing::HasSubstr;

class MtlTexture : public ObjFiles {
  protected:
    void writeImage(const std::string& name) {
        const std::filesystem::path path = folder_ / name;
        std::filesystem::create_directories(path.parent_path());
        rayscope::writeImage((folder_ / "image.pfm").string(), RgbImage(2, 1));
        std::filesystem::rename(folder_ / "image.pfm", path);
    }
    /// The file of the texture without the folder; "" if there is none.
    std::string textureOf(std::string_view arguments) {
        const Material material = materialOf(fmt::format("newmtl m\nKd 1 1 1\nmap_Kd {}\n", arguments));
        if (!material.kdTexture) return "";
        wrap_ = material.kdTexture->wrap;
        return std::filesystem::relative(material.kdTexture->file, folder_).string();
    }
    TextureWrap wrap_ = TextureWrap::Repeat;
};

struct OptionCase {
    std::string_view arguments;
    bool clamps, isMoved;
    std::string_view ignored;
};

TEST_F(MtlTexture, OptionsStandBeforeOrBehindTheName) {
    const OptionCase cases[] = {
        {"", false, false, ""},
        {"-clamp on", true, false, ""},
        {"-clamp off", false, false, ""},
        {"-s 2", false, true, ""},
        {"-s 2 2", false, true, ""},
        {"-s 2 2 2", false, true, ""},
        {"-s 1 1 1", false, false, ""},
        {"-o 0.5", false, true, ""},
        {"-o 0.5 0 0", false, true, ""},
        {"-o 0 0 0", false, false, ""},
        {"-t 0 0 0", false, false, ""},
        {"-t 0.1 0.1", false, true, ""},
        {"-mm 0 1", false, false, ""},
        {"-mm 0.2 0.9", false, false, "-mm"},
        {"-blendu on", false, false, ""},
        {"-blendu off", false, false, "-blendu"},
        {"-blendv off", false, false, "-blendv"},
        {"-cc off", false, false, ""},
        {"-cc on", false, false, "-cc"},
        {"-bm 1", false, false, ""},
        {"-bm 0.5", false, false, "-bm"},
        {"-boost 0", false, false, ""},
        {"-boost 3", false, false, "-boost"},
        {"-texres 512", false, false, "-texres"},
        {"-imfchan l", false, false, "-imfchan"},
        {"-type sphere", false, false, "-type"},
        {"-colorspace sRGB", false, false, ""},
        {"-clamp on -s 2 2 -mm 0 1 -o -0.5 -blendu on", true, true, ""},
    };
    for (const OptionCase& c : cases)
        for (const std::string& arguments :
             {fmt::format("{} t.png", c.arguments), fmt::format("t.png {}", c.arguments),
              fmt::format("{} a b.png", c.arguments), fmt::format("\"a b.png\" {} # comment", c.arguments)}) {
            SCOPED_TRACE(arguments);
            const scene::TextureArguments texture = scene::parseTexture(arguments);
            EXPECT_TRUE(texture.file.starts_with("t.png") || texture.file.starts_with("a b.png") ||
                        texture.file.starts_with("\"a b.png\""))
                << texture.file;
            EXPECT_EQ(texture.file.find(" -"), std::string_view::npos) << texture.file;
            EXPECT_EQ(texture.clamps, c.clamps);
            EXPECT_EQ(texture.isMoved, c.isMoved);
            EXPECT_FALSE(texture.isIncomplete);
            EXPECT_EQ(fmt::format("{}", fmt::join(texture.ignored, " ")), c.ignored);
        }
}

TEST_F(MtlTexture, NamesMayLookLikeOptionsOrNumbers) {
    EXPECT_EQ(scene::parseTexture("-s 2 2 2").file, "2");
    EXPECT_EQ(scene::parseTexture("-s 2 2 2 2").file, "2");
    EXPECT_EQ(scene::parseTexture("wood -s.png").file, "wood -s.png");
    EXPECT_EQ(scene::parseTexture("wood -s x.png").file, "wood -s x.png");
    EXPECT_EQ(scene::parseTexture("-wood.png").file, "-wood.png");
    EXPECT_EQ(scene::parseTexture("-clamp on").file, "");
    EXPECT_EQ(scene::parseTexture("").file, "");
    EXPECT_TRUE(scene::parseTexture("-mm 0 wood.png").isIncomplete);
    EXPECT_TRUE(scene::parseTexture("-s wood.png").isIncomplete);
    EXPECT_EQ(scene::parseTexture("-s wood.png").file, "wood.png");
}

TEST_F(MtlTexture, OptionsWithoutEffectAreWarnings) {
    writeImage("t.pfm");
    EXPECT_EQ(textureOf("-s 2 2 1 t.pfm"), "t.pfm");
    EXPECT_EQ(notesText(), "m.mtl:3: warning: map_Kd with scale or offset (-s, -o, -t), which are ignored\n");
    EXPECT_EQ(textureOf("-mm 0 2 -cc on t.pfm"), "t.pfm");
    EXPECT_EQ(notesText(), "m.mtl:3: warning: ignored options of map_Kd: -cc, -mm\n");
    EXPECT_EQ(textureOf("-mm 1 t.pfm"), "t.pfm");
    EXPECT_THAT(notesText(),
                HasSubstr("m.mtl:3: warning: options of map_Kd without their values; ignored\n"));
    EXPECT_EQ(textureOf("-clamp on"), "");
    EXPECT_EQ(notesText(), "m.mtl:3: warning: map_Kd without a file name; ignored\n");
    EXPECT_EQ(textureOf("t.pfm -clamp on"), "t.pfm");
    EXPECT_EQ(wrap_, TextureWrap::Clamp);
    EXPECT_EQ(notesText(), "");
}

TEST_F(MtlTexture, NamesAreReadInAllSpellings) {
    writeImage("t.pfm");
    writeImage("dir/a b.pfm");
    writeImage("no#1.pfm");
    writeImage("M\xc3\xbcller.pfm");
    const std::pair<std::string_view, std::string_view> names[] = {
        {"t.pfm", "t.pfm"},
        {"  t.pfm \t", "t.pfm"},
        {"./t.pfm", "t.pfm"},
        {".\\t.pfm", "t.pfm"},
        {"\"t.pfm\"", "t.pfm"},
        {"'t.pfm'", "t.pfm"},
        {"t.pfm # comment", "t.pfm"},
        {"\"t.pfm\" # comment", "t.pfm"},
        {"dir/a b.pfm", "dir/a b.pfm"},
        {"dir\\a b.pfm", "dir/a b.pfm"},
        {"\"dir/a b.pfm\"", "dir/a b.pfm"},
        {"dir/a\\ b.pfm", "dir/a b.pfm"},
        {"dir/../dir/a b.pfm", "dir/a b.pfm"},
        {"no#1.pfm", "no#1.pfm"},
        {"M\xc3\xbcller.pfm", "M\xc3\xbcller.pfm"},
    };
    for (const auto& [written, file] : names) {
        EXPECT_EQ(textureOf(written), file) << written;
        EXPECT_EQ(notesText(), "") << written;
    }
    EXPECT_EQ(textureOf("M\xfcller.pfm"), "M\xc3\xbcller.pfm");
    EXPECT_THAT(notesText(), HasSubstr("Windows-1252"));
}

TEST_F(MtlTexture, FilesElsewhereAreFoundBesideTheMtl) {
    writeImage("t.pfm");
    for (const std::string_view name :
         {"C:\\Users\\x\\t.pfm", "/nowhere/t.pfm", "textures/t.pfm", "..\\..\\maps\\t.pfm",
          "\"D:/my maps/t.pfm\"", "T.PFM", "//server/share/T.pfm"}) {
        EXPECT_EQ(textureOf(name), "t.pfm") << name;
        EXPECT_THAT(notesText(), HasSubstr("m.mtl:3: warning: texture '")) << name;
        EXPECT_THAT(notesText(), HasSubstr("' is not found; ")) << name;
    }
}

TEST_F(MtlTexture, UnreadableTexturesAreOneWarning) {
    write("empty.png", "");
    ASSERT_EQ(::mkfifo((folder_ / "pipe.png").c_str(), 0600), 0);
    EXPECT_EQ(textureOf("gone.png"), "");
    EXPECT_EQ(notesText(), "m.mtl:3: warning: texture 'gone.png' is not found; Kd is used\n");
    EXPECT_EQ(textureOf("empty.png"), "");
    EXPECT_THAT(notesText(), HasSubstr("m.mtl:3: warning: texture empty.png: "));
    EXPECT_EQ(textureOf("pipe.png"), "");
    EXPECT_EQ(notesText(),
              "m.mtl:3: warning: texture 'pipe.png' is a pipe or device, not a regular file; Kd is used\n");
    EXPECT_EQ(textureOf("/dev/zero"), "");
    EXPECT_THAT(notesText(), HasSubstr("is a pipe or device"));
    EXPECT_EQ(textureOf("."), "");
    EXPECT_THAT(notesText(), HasSubstr("is a folder, not a file"));

    std::string many;
    for (int i = 0; i < 1000; ++i) many += fmt::format("newmtl m{0}\nKd 1 1 1\nmap_Kd {0}.png\n", i);
    materialOf(many + "newmtl m\nKd 1 1 1\n");
    EXPECT_EQ(notesText(),
              "m.mtl:3: warning: texture '0.png' is not found; Kd is used (and 999 other textures)\n");
}

}  // namespace
}  // namespace rayscope::test
