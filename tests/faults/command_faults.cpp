#include "faults/command_faults.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rayscope/image.h>
#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>

#include "faults/forked_command.h"

namespace rayscope::test {

namespace {

constexpr const char* kScene = R"(version = 1
[[camera]]
look_from = [0, 0, 3]
lens = { f_number = 2, focal_length = 0.05, focus_distance = 3 }
[material.shiny]
kd = [0.5, 0.5, 0.5]
ks = [0.5, 0.5, 0.5]
kd_texture = "texture.png"
[[mesh]]
file = "mesh.obj"
[[mesh]]
generate = { shape = "quad", size = [2, 2] }
transform = { translate = [0, 0, -1] }
material = "shiny"
[[mesh]]
generate = { shape = "terrain", cells = [8, 8] }
[[sphere]]
center = [0.5, 0, 0]
radius = 0.3
material = "shiny"
motion = [0, 0.1, 0]
[[light]]
type = "parallelogram"
corner = [0, 2, 0]
edges = [[1, 0, 0], [0, 0, 1]]
[environment]
equirect = "sky.hdr"
[settings]
glossy = true
bloom = true
)";

constexpr const char* kObj = R"(mtllib mesh.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0.5 1.5 0
vt 0 0
vt 1 0
vt 1 1
usemtl textured
f 1/1 2/2 3/3 5/2 4/1
)";

constexpr const char* kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
    "face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

constexpr const char* kStl =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
    "0\nendloop\nendfacet\nendsolid s\n";

constexpr const char* kGltf =
    R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{)"
    R"("attributes":{"POSITION":0}}]}],"accessors":[{"componentType":5126,"count":3,"type":"VEC3",)"
    R"("min":[0,0,0],"max":[1,1,0],"bufferView":0}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
    R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
    R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

RgbImage gradient(int width, int height, float step) {
    RgbImage image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.at(x, y) = step * Rgb(static_cast<float>(x), static_cast<float>(y), 1.0f);
    return image;
}

void writeInputs(const TemporaryFolder& folder) {
    folder.write("scene.toml", kScene);
    folder.write("mesh.obj", kObj);
    folder.write("mesh.mtl", "newmtl textured\nKd 1 1 1\nmap_Kd texture.png\n");
    folder.write("mesh.ply", kPly);
    folder.write("mesh.stl", kStl);
    folder.write("mesh.gltf", kGltf);
    folder.write("rays.rays", std::string(32 * 64, '\0'));
    for (const char* name : {"a.exr", "a.png", "a.hdr", "sky.hdr", "texture.png", "a.pfm", "a.ppm"})
        writeImage((folder / name).string(), gradient(16, 8, 0.05f));
    for (const char* name : {"b.exr", "b.png", "b.hdr", "b.pfm", "b.ppm"})
        writeImage((folder / name).string(), gradient(16, 8, 0.04f));
}

std::set<std::string> filesIn(const TemporaryFolder& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        names.insert(entry.path().filename().string());
    return names;
}

std::string describe(const FaultyCommand& command, const Fault& fault) {
    std::string text = "rayscope";
    for (const std::string& argument : command.arguments) text += " " + argument;
    return fmt::format("{}\n{} {}{} fails", text, fault.kind == FaultKind::Thread ? "thread" : "allocation",
                       fault.point, fault.andAllAfter ? " and every later one" : "");
}

/// Whether a message names the lack of memory or threads.
bool namesReason(const std::string& err, FaultKind kind) {
    const auto has = [&](const char* text) { return err.find(text) != std::string::npos; };
    const bool aboutThreads = has("error: the system does not start more threads");
    // The system's text for the same, where a file or folder is opened.
    const bool aboutMemory = has("error: out of memory") || has("Cannot allocate memory");
    return aboutThreads || (kind == FaultKind::Allocation && aboutMemory);
}

/// Runs one command with faults in a folder of its own.
class Trial {
  public:
    explicit Trial(const FaultyCommand& command) : command_(command) {
        writeInputs(folder_);
        inputs_ = filesIn(folder_);
    }

    /// The number of points of a kind in a run without a fault.
    std::uint64_t runWithout(FaultKind kind) {
        const CommandOutcome outcome = runForked(folder_, command_.arguments, {kind, 0, false});
        EXPECT_TRUE(isSuccess(outcome)) << describe(command_, {}) << "\n" << outcome.err;
        out_ = outcome.out;
        for (const std::string& name : command_.outputs) contents_[name] = readText(folder_ / name);
        removeOutputs();
        return outcome.calls;
    }

    void runWith(const Fault& fault) {
        const CommandOutcome outcome = runForked(folder_, command_.arguments, fault);
        SCOPED_TRACE(describe(command_, fault) + "\n" + outcome.err);
        EXPECT_TRUE(isSuccess(outcome) || outcome.status == 2) << outcome.status;
        EXPECT_TRUE(isSuccess(outcome) || namesReason(outcome.err, fault.kind));
        if (isSuccess(outcome)) checkSuccess(outcome);
        checkFiles();
        removeOutputs();
    }

  private:
    bool isSuccess(const CommandOutcome& outcome) const {
        return outcome.status == 0 || outcome.status == command_.otherCode;
    }
    void checkSuccess(const CommandOutcome& outcome) {
        EXPECT_TRUE(!command_.sameText || outcome.out == out_) << outcome.out;
        for (const auto& [name, content] : contents_) checkContent(name, content);
    }

    /// A library that lacks memory to compress a block writes it as it is; the pixels are the same.
    void checkContent(const std::string& name, const std::string& content) {
        if (readText(folder_ / name) == content) return;
        EXPECT_TRUE(name.ends_with(".exr") || name.ends_with(".png")) << name;
        folder_.write("expected." + name, content);
        EXPECT_EQ(readImage((folder_ / name).string()).pixels,
                  readImage((folder_ / ("expected." + name)).string()).pixels)
            << name;
        std::filesystem::remove(folder_ / ("expected." + name));
    }

    /// What exists is complete.
    void checkFiles() {
        for (const std::string& name : filesIn(folder_)) {
            if (inputs_.contains(name) || std::ranges::count(command_.others, name) > 0) continue;
            if (!contents_.contains(name)) {
                ADD_FAILURE() << "left: " << name;
                continue;
            }
            checkContent(name, contents_[name]);
        }
    }

    void removeOutputs() {
        for (const std::string& name : filesIn(folder_))
            if (!inputs_.contains(name)) std::filesystem::remove_all(folder_ / name);
    }

    const FaultyCommand& command_;
    TemporaryFolder folder_;
    std::set<std::string> inputs_;
    std::string out_;
    std::map<std::string, std::string> contents_;
};

}  // namespace

void PrintTo(const FaultyCommand& command, std::ostream* to) { *to << command.name; }

const std::vector<FaultyCommand>& faultyCommands() {
    static const std::vector<FaultyCommand> commands{
        {"Render",
         {"render", "scene.toml", "--size", "12x8", "--spp", "2", "-q", "-t", "2", "-o", "o.png", "-o",
          "o.exr", "-o", "o.hdr", "-o", "o.pfm", "-o", "o.ppm"},
         {"o.png", "o.exr", "o.hdr", "o.pfm", "o.ppm"}},
        {"RenderWithAovs",
         {"render", "builtin:cornell", "--size", "8x8", "--spp", "1", "-q", "-t", "2", "-o", "o.pfm", "--aov",
          "normal,nodes,variance", "--stats", "s.json"},
         {"o.pfm", "o.normal.pfm", "o.nodes.pfm", "o.variance.pfm"},
         {"s.json"}},
        {"RenderUntilAccurate",
         {"render", "builtin:triangle", "--size", "16x16", "--target-error", "0.5", "-q", "-t", "2", "-o",
          "o.pfm"},
         {"o.pfm"}},
        {"Cast", {"cast", "scene.toml", "--rays", "rays.rays", "-q", "-t", "2", "-o", "o.hits"}, {"o.hits"}},
        {"Probe",
         {"probe", "scene.toml", "--size", "16x16", "--pixel", "8,8", "-t", "2", "--json", "o.json"},
         {"o.json"}},
        {"InfoToml", {"info", "scene.toml", "--json"}, {}},
        {"InfoObj", {"info", "mesh.obj"}, {}},
        {"InfoPly", {"info", "mesh.ply"}, {}},
        {"InfoStl", {"info", "mesh.stl"}, {}},
        {"InfoGltf", {"info", "mesh.gltf"}, {}},
        {"CompareExr", {"compare", "a.exr", "b.exr", "-o", "o.png"}, {"o.png"}},
        {"ComparePng", {"compare", "a.png", "b.png", "-o", "o.exr"}, {"o.exr"}},
        {"CompareHdr", {"compare", "a.hdr", "b.pfm"}, {}},
        {"ComparePpm", {"compare", "a.ppm", "b.ppm"}, {}},
        {"Lab",
         {"lab", "builtin:triangle", "--quick", "--rays", "10", "-q", "-t", "2", "-o", "lab"},
         {},
         {"lab"},
         false},
        {"Trade",
         {"trade", "builtin:triangle", "--size", "4x4", "--budget", "0.1", "-t", "2", "-o", "trade"},
         {},
         {"trade"},
         false,
         3},
        {"Bench",
         {"bench", "builtin:triangle", "--size", "8", "--rounds", "5", "-t", "2", "--json", "o.json"},
         {},
         {"o.json"},
         false},
    };
    return commands;
}

std::vector<FaultyCommand> commandsWithThreads() {
    std::vector<FaultyCommand> found;
    for (const FaultyCommand& command : faultyCommands())
        if (std::ranges::count(command.arguments, "-t") > 0) found.push_back(command);
    return found;
}

void expectClearEnds(const FaultyCommand& command, FaultKind kind, std::uint64_t most) {
    Trial trial(command);
    const std::uint64_t points = trial.runWithout(kind);
    ASSERT_GT(points, kind == FaultKind::Allocation ? 100u : 0u);
    const std::uint64_t chosen = std::min(points, most);
    std::uint64_t tried = 0;
    for (; tried < chosen && !testing::Test::HasFailure(); ++tried) {
        const std::uint64_t point = 1 + tried * points / chosen;
        trial.runWith({kind, point, false});
        trial.runWith({kind, point, true});
    }
    fmt::print("{}: {} of {} points, each alone and with all later ones\n", command.name, tried, points);
}

}  // namespace rayscope::test
