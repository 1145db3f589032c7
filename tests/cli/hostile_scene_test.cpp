// What SECURITY.md promises about a scene that somebody else made: it may read what the user can read, but it
// writes nothing besides the outputs, starts nothing, shows no text of other files, and does not wait or
// allocate without end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "support/run_program.h"

namespace rayscope {
namespace {

using test::ProgramResult;
using test::run;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

const std::string kCamera = "[[camera]]\nlook_from = [0, 0, 3]\n";
const std::string kSphere = "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n";

std::string sceneWith(const std::string& rest) { return "version = 1\n" + kCamera + kSphere + rest; }

/// Files that hold a secret, in the forms in which secrets are kept.
const std::map<std::string, std::string> kSecrets{
    {"words", "hunter2 hunter2\nroot:hunter2:0:0:hunter2:/:/hunter2\n"},
    {"key", "-----BEGIN KEY-----\nhunter2/hunter2==\n-----END KEY-----\n"},
    {"table", "[hunter2]\npassword = hunter2 hunter2\nhunter2 = \"hunter2\"\n"},
    {"json", "{\"hunter2\": \"hunter2\" \"hunter2\"}"},
    {"lines", "{\"hunter2\": 1}\n{\"hunter2\": 2}\n"},
    {"binary", std::string("\0\1hunter2\0\xff", 11) + "hunter2"},
    {"line", "hunter2"},
};

/// Scenes that use the file at a path as everything that they can name.
std::map<std::string, std::string> scenesThatRead(const std::string& path) {
    std::map<std::string, std::string> scenes{
        {"mesh.toml", sceneWith("[[mesh]]\nfile = \"" + path + "\"\n")},
        {"texture.toml", sceneWith("[material.a]\nkd_texture = \"" + path + "\"\n")},
        {"environment.toml", sceneWith("[environment]\nequirect = \"" + path + "\"\n")},
        {"cube.toml",
         sceneWith("[environment]\ncube = { px = \"" + path + "\", nx = \"" + path + "\", py = \"" + path +
                   "\", ny = \"" + path + "\", pz = \"" + path + "\", nz = \"" + path + "\" }\n")},
        {"library.obj", "mtllib " + path + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"},
        {"map.obj", "mtllib map.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"},
        {"map.mtl", "newmtl a\nmap_Kd " + path + "\n"},
        {"points.ply", "ply\nformat ascii 1.0\ncomment TextureFile " + path +
                           "\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
                           "z\nelement face 1\nproperty list "
                           "uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    };
    for (const char* place : {"buffers", "images"})
        scenes[std::string(place) + ".gltf"] =
            std::string("{\"asset\":{\"version\":\"2.0\"},\"") + place + "\":[{\"byteLength\":4,\"uri\":\"" +
            path +
            "\"}],\"textures\":[{\"source\":0}],\"materials\":[{\"pbrMetallicRoughness\":{"
            "\"baseColorTexture\":{\"index\":0}}}"
            "],\"bufferViews\":[{\"buffer\":0,\"byteLength\":4}],\"accessors\":[{\"bufferView\":0,"
            "\"componentType\":5121,"
            "\"count\":1,\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},"
            "\"material\":0}]}],"
            "\"nodes\":[{\"mesh\":0}],\"scenes\":[{\"nodes\":[0]}]}";
    return scenes;
}

void expectNoSecret(const ProgramResult& result, const std::string& context) {
    for (const std::string& text : {result.out, result.err})
        EXPECT_THAT(text, Not(HasSubstr("hunter2"))) << context;
    EXPECT_LE(result.exitCode, 2) << context << "\n" << result.err;
}

TEST(HostileScene, NoTextOfOtherFilesIsShown) {
    for (const auto& [form, secret] : kSecrets) {
        const TemporaryFolder folder;
        fs::create_directories(folder / "other");
        fs::create_directories(folder / "scene");
        folder.write("other/secret", secret);
        fs::create_symlink("../other/secret", folder / "scene/link");
        std::vector<std::string> paths{"link"};
        if (form == "words") paths.insert(paths.end(), {"../other/secret", folder.file("other/secret")});
        for (const std::string& path : paths)
            for (const auto& [name, scene] : scenesThatRead(path)) {
                folder.write("scene/" + name, scene);
                if (!name.ends_with(".mtl"))
                    expectNoSecret(run(folder, "rayscope info scene/" + name),
                                   form + " as " + name + " by " + path);
            }
    }
}

TEST(HostileScene, NoTextOfALinkedFileIsShown) {
    for (const auto& [form, secret] : kSecrets) {
        const TemporaryFolder folder;
        folder.write("secret", secret);
        for (const char* name : {"a.obj", "a.ply", "a.stl", "a.gltf", "a.glb", "a.png", "a.mtl"})
            fs::create_symlink("secret", folder / name);
        folder.write("a.toml", sceneWith("[material.a]\nkd_texture = \"a.png\"\n"));
        folder.write("b.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
        for (const char* name : {"a.obj", "a.ply", "a.stl", "a.gltf", "a.glb", "a.toml", "b.obj"})
            expectNoSecret(run(folder, std::string("rayscope info ") + name), form + " as " + name);
        expectNoSecret(run(folder, "rayscope compare a.png a.png"), form + " as an image");
    }
}

/// All files and folders below a folder, with their contents.
std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        found[entry.path().lexically_relative(folder).string()] =
            entry.is_regular_file() ? test::readText(entry.path()) : "";
    return found;
}

TEST(HostileScene, OnlyTheOutputsAreWritten) {
    const TemporaryFolder folder;
    for (const char* name : {"private", "config", "scene", "work"}) fs::create_directories(folder / name);
    const std::string name = "../../private/evil$(touch evil)`touch evil`; touch evil\\u0000";
    folder.write("scene/a.toml", "version = 1\ntitle = \"" + name + "\"\n[[camera]]\nname = \"" + name +
                                     "\"\nlook_from = [0, 0, 3]\n[[sphere]]\nname = \"" + name +
                                     "\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"" + name +
                                     "\"\n[material.\"" + name +
                                     "\"]\nkd = [1, 1, 1]\n[[mesh]]\ngenerate = { shape = \"quad\" "
                                     "}\n[[light]]\ntype = \"point\"\nposition = [0, 2, 3]\n");
    const std::string scene = " ../scene/a.toml ";
    const std::pair<std::string, std::set<std::string>> commands[] = {
        {"info" + scene, {}},
        {"render" + scene + "-o o.png --size 8x8 --spp 1 --aov depth --stats s.json",
         {"o.png", "o.depth.exr", "s.json"}},
        {"probe" + scene + "--size 9x9 --pixel 4,4 --explain --json j.json", {"j.json"}},
        {"bench" + scene + "--size 8 --rounds 5 -t 1 --json b.json", {"b.json"}},
        {"lab" + scene + "--quick --rays 10 -q -o lab", {}},
        {"trade" + scene + "--size 8x8 --budget 0.2 --no-cache -q -o trade", {}},
    };
    const auto before = contents(folder.path());
    for (const auto& [command, outputs] : commands) {
        const ProgramResult result = run(
            folder,
            "cd work && HOME=../private XDG_CACHE_HOME= XDG_CONFIG_HOME= '" RAYSCOPE_PROGRAM "' " + command);
        EXPECT_EQ(result.exitCode, 0) << command << "\n" << result.err;
        for (const std::string& output : outputs)
            EXPECT_TRUE(fs::remove(folder / ("work/" + output))) << command << output;
        for (const char* report : {"work/lab", "work/trade"}) {
            if (!command.starts_with(fs::path(report).filename().string())) continue;
            EXPECT_TRUE(fs::is_directory(folder / report)) << command;
            fs::remove_all(folder / report);
        }
        auto after = contents(folder.path());
        after.erase(".out");
        after.erase(".err");
        EXPECT_EQ(after, before) << command;
    }
}

/// Runs a command with at most 20 seconds and, without sanitizers, which reserve more, 4 GB of address space.
ProgramResult runLimited(const TemporaryFolder& folder, const std::string& arguments) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    const std::string limit;
#else
    const std::string limit = "ulimit -v 4000000; ";
#endif
    return run(folder, limit + "timeout 120 '" RAYSCOPE_PROGRAM "' " + arguments);
}

TEST(HostileScene, PipesDevicesAndCirclesOfLinksAreRefused) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_symlink("circle", folder / "circle");
    fs::create_symlink("/dev/zero", folder / "link");
    for (const std::string path : {"pipe", "circle", "link", "/dev/stdin", "/proc/self/mem", "."})
        for (const auto& [name, scene] : scenesThatRead(path)) {
            folder.write(name, scene);
            if (name.ends_with(".mtl")) continue;
            const ProgramResult result = runLimited(folder, "info " + name + " </dev/zero");
            EXPECT_LE(result.exitCode, 2) << path << " in " << name << "\n" << result.err;
            EXPECT_THAT(result.err, Not(HasSubstr("memory"))) << path << " in " << name;
        }
}

TEST(HostileScene, AnnouncedSizesAllocateNothing) {
    const TemporaryFolder folder;
    const std::string header =
        "property float x\nproperty float y\nproperty float z\nelement face 2000000000\nproperty list "
        "uchar int vertex_indices\nend_header\n";
    folder.write("a.ply", "ply\nformat ascii 1.0\nelement vertex 2000000000\n" + header);
    folder.write("b.ply", "ply\nformat binary_big_endian 1.0\nelement vertex 2000000000\n" + header);
    folder.write("a.stl", std::string(80, ' ') + "\xff\xff\xff\x7f" + std::string(50, '\0'));
    folder.write(
        "a.gltf",
        R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{)"
        R"("attributes":{"POSITION":0}}]}],"accessors":[{"componentType":5126,"count":2000000000,"type":"VEC3"}]})");
    folder.write("b.gltf", std::string(1000000, '['));
    folder.write("a.ppm", "P6\n16000 16000\n255\n" + std::string(1000, '\0'));
    folder.write("a.toml", sceneWith("[material.a]\nkd_texture = \"a.ppm\"\n"));
    folder.write("b.toml", "version = 1\na = " + std::string(100000, '['));
    std::string key = "version = 1\n";
    for (int i = 0; i < 60000; ++i) key += "a.";
    folder.write("c.toml", key + "b = 1\n");
    for (const char* name : {"a.ply", "b.ply", "a.stl", "a.gltf", "b.gltf", "a.toml", "b.toml", "c.toml"}) {
        const ProgramResult result = runLimited(folder, std::string("info ") + name);
        EXPECT_EQ(result.exitCode == 2 || std::string(name) == "a.stl", true) << name << "\n" << result.err;
        EXPECT_THAT(result.err, Not(HasSubstr("memory"))) << name;
    }
}

/// A file may hold a message per line: the program prints some of them.
TEST(HostileScene, MessagesAreFew) {
    const TemporaryFolder folder;
    std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nmtllib a.mtl\n", mtl, spheres = "version = 1\n";
    for (int i = 0; i < 3000; ++i) {
        const std::string n = std::to_string(i);
        obj += "mtllib none" + n + ".mtl\nusemtl m" + n + "\nf 1 2 3\nk" + n + " 1\n";
        mtl += "newmtl m" + n + "\nmap_Kd none" + n + ".png\nk" + n + " 1\n";
        spheres += kSphere + "material = \"m" + n + "\"\n";
    }
    folder.write("a.obj", obj);
    folder.write("a.mtl", mtl);
    folder.write("a.toml", spheres);
    for (const char* name : {"a.obj", "a.toml"}) {
        const ProgramResult result = runLimited(folder, std::string("info ") + name);
        EXPECT_LE(result.exitCode, 2) << name;
        EXPECT_LE(std::ranges::count(result.err, '\n'), 200) << name;
        EXPECT_LE(std::ranges::count(result.out, '\n'), 200) << name;
    }
}

}  // namespace
}  // namespace rayscope
