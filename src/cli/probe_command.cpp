#include <fmt/format.h>

#include <rayscope/probe.h>

#include "base/atomic_file.h"
#include "cli/commands.h"
#include "cli/number_list.h"
#include "cli/scene_options.h"
#include "trace/compile.h"

namespace rayscope {

namespace {

struct ProbeOptions {
    SceneOptions scene;
    std::string pixel, jsonFile;
    int sample = 0;
};

int runProbe(const ProbeOptions& options) {
    const RenderRequest request = openScene(options.scene, false);
    const glm::ivec2 pixel = parsePair("--pixel", options.pixel, ',', 0);
    if (pixel.x >= request.width || pixel.y >= request.height)
        throw CLI::ValidationError("--pixel", fmt::format("the image has {} x {} pixels, counted from 0,0",
                                                          request.width, request.height));
    const auto world =
        compile({request.scene, request.settings, request.camera, request.width, request.height});
    const RayTree tree = probe(*world, request.seed, {pixel.x, pixel.y, options.sample});
    fmt::print("{}", toText(tree, *world));
    if (!options.jsonFile.empty()) writeFileAtomically(options.jsonFile, toJson(tree, *world));
    return kDone;
}

}  // namespace

void addProbeCommand(CLI::App& program, int& exitCode) {
    auto options = std::make_shared<ProbeOptions>();
    CLI::App* command =
        program.add_subcommand("probe", "Print the ray tree of one pixel, as R shows it in the window");
    options->scene.addTo(*command, true);
    command->add_option("--pixel", options->pixel, "The pixel as X,Y, counted from 0,0 at the top left")
        ->required();
    command->add_option("--sample", options->sample, "Index of the sample of the pixel")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    command->add_option("--json", options->jsonFile, "Write the tree to this file as JSON, too");
    command->callback([options, &exitCode] { exitCode = runProbe(*options); });
}

}  // namespace rayscope
