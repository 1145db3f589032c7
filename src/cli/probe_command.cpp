#include <fmt/format.h>

#include <rayscope/probe.h>
#include <rayscope/render_image.h>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/console.h"
#include "base/json_text.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/scene_options.h"
#include "probe/diagnosis.h"
#include "probe/traversal_log.h"
#include "trace/world.h"

namespace rayscope::cli {

namespace {

struct ProbeOptions {
    SceneOptions scene;
    std::optional<glm::ivec2> pixel;
    std::string jsonFile;
    std::string traversal;  ///< "3" or "s3"
    std::string layout = "binary";
    int sample = 0;
    bool explain = false;
};

[[noreturn]] void noSuchRay(const std::string& name, const RayTree& tree) {
    std::string shadowRays;
    if (!tree.shadowRays.empty())
        shadowRays = fmt::format(" or a shadow ray s0 … s{}", tree.shadowRays.size() - 1);
    throw UsageError("--traversal", fmt::format("expected a ray 0 … {}{}, got {}", tree.nodes.size() - 1,
                                                shadowRays, base::quoted(name)));
}

/// The traversals of a ray, one per motion group. `name` is its number in the tree, after an "s" for shadow
/// rays.
std::vector<probe::TraversalLog> traversalsOf(const trace::World& world, const RayTree& tree,
                                              const std::string& name, BvhLayout layout) {
    const bool isShadow = name.starts_with("s");
    const std::string digits = name.substr(isShadow ? 1 : 0);
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const std::size_t count = isShadow ? tree.shadowRays.size() : tree.nodes.size();
    if (error != std::errc{} || end != digits.data() + digits.size() || number >= count)
        noSuchRay(name, tree);
    return isShadow ? probe::recordAnyHit(world, tree.shadowRays[number].ray, tree.time, layout)
                    : probe::recordClosestHit(world, tree.nodes[number].ray, tree.time, layout);
}

/// Tree, traversals and diagnosis as one JSON object.
std::string asJson(const RayTree& tree, const trace::World& world,
                   const std::vector<probe::TraversalLog>& traversals,
                   const std::vector<probe::Diagnosis>& diagnoses) {
    nlohmann::json j = nlohmann::json::parse(toJson(tree, world));
    for (const probe::TraversalLog& log : traversals)
        j["traversal"].push_back(nlohmann::json::parse(probe::toJson(log)));
    for (const probe::Diagnosis& diagnosis : diagnoses) {
        nlohmann::json entry = {{"symptom", probe::nameOf(diagnosis.symptom)},
                                {"cause", probe::nameOf(diagnosis.cause)},
                                {"sentence", diagnosis.sentence}};
        entry["rays"] = nlohmann::json::array();
        for (const probe::Evidence& e : diagnosis.evidence)
            entry["rays"].push_back(
                {{"sample", e.sample}, {e.shadow >= 0 ? "shadow_ray" : "node", std::max(e.node, e.shadow)}});
        j["explanation"].push_back(std::move(entry));
    }
    return base::jsonText(j);
}

int runProbe(const ProbeOptions& options) {
    const RenderRequest request = openScene(options.scene, false, progressStyle("", false));
    const glm::ivec2 pixel = *options.pixel;
    if (pixel.x >= request.width || pixel.y >= request.height)
        throw UsageError("--pixel", fmt::format("the image has {} x {} pixels, counted from 0,0",
                                                request.width, request.height));
    const auto world = compileScene(request);
    const RayTree tree = probeSample(*world, request.seed, {pixel.x, pixel.y, options.sample});
    std::vector<probe::TraversalLog> traversals;
    if (!options.traversal.empty())
        traversals = traversalsOf(*world, tree, options.traversal,
                                  options.layout == "wide" ? BvhLayout::Wide : BvhLayout::Binary);
    base::print("{}", toText(tree, *world));
    for (const probe::TraversalLog& log : traversals) base::print("{}", probe::toText(log));
    if (!options.traversal.empty() && traversals.empty()) base::print("no BVH to traverse\n");
    std::vector<probe::Diagnosis> diagnoses;
    if (options.explain)
        diagnoses = probe::diagnosePixel(*world, request.seed, pixel.x, pixel.y,
                                         probe::samplesToDiagnose(request.settings));
    for (const probe::Diagnosis& diagnosis : diagnoses) base::print("{}", probe::toText(diagnosis));
    if (options.explain && diagnoses.empty()) base::print("no anomaly found in this pixel\n");
    if (!options.jsonFile.empty())
        base::writeFileAtomically(options.jsonFile, asJson(tree, *world, traversals, diagnoses));
    return kSuccess;
}

}  // namespace

std::function<int()> setUpProbe(OptionList& list) {
    auto options = std::make_shared<ProbeOptions>();
    options->scene.addTo(list, true);
    list.add("--pixel", &options->pixel, "The pixel, counted from 0,0 at the top left")
        .form("X,Y", ',')
        .from(0, 1 << 20)
        .required();
    list.add("--sample", &options->sample, "Index of the sample of the pixel")
        .from(0, std::numeric_limits<int>::max())
        .showDefault();
    list.add("--traversal", &options->traversal,
             "Also print the BVH traversal of a ray: its number in the tree, with an s before it for a "
             "shadow ray; the camera ray if no number is given")
        .form("RAY")
        .valueOptional("0");
    list.add("--layout", &options->layout,
             "BVH that --traversal uses: binary, or the wide one that renders use")
        .choices({"binary", "wide"})
        .showDefault();
    list.add("--explain", &options->explain,
             "Print a diagnosis: why the pixel is black, bright, noisy, slow or not finite");
    list.add("--json", &options->jsonFile, "Also write the tree to this file, as JSON")
        .writes(Option::Output::File);
    return [options] { return runProbe(*options); };
}

}  // namespace rayscope::cli
