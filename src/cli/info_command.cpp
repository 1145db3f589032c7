#include <fmt/format.h>

#include <rayscope/scene.h>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/json_text.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/load_progress.h"
#include "cli/scene_options.h"

namespace rayscope::cli {

namespace {

struct InfoOptions {
    std::string scene;
    bool json = false, list = false;
};

using base::printable;

nlohmann::json diagnosticJson(const Diagnostic& diagnostic) {
    constexpr const char* severities[] = {"note", "warning", "error"};
    return {{"severity", severities[static_cast<int>(diagnostic.severity)]},
            {"message", diagnostic.message},
            {"file", diagnostic.position.file},
            {"line", diagnostic.position.line},
            {"column", diagnostic.position.column}};
}

int listScenes(bool json) {
    nlohmann::json list = nlohmann::json::array();
    for (const BuiltinScene& scene : builtinScenes()) {
        if (!json) base::print("builtin:{:<20} {}\n", scene.name, scene.title);
        list.push_back({{"name", "builtin:" + scene.name}, {"title", scene.title}});
    }
    if (json) base::writeOutput(base::jsonText(list));
    return kSuccess;
}

struct Opened {
    SceneDescription scene;
    SceneRequirements needs;
    SceneBounds bounds;
    Diagnostics findings;
};

void printText(const Opened& opened) {
    const auto& [scene, needs, bounds, findings] = opened;
    base::print("{}\n", printable(scene.path));
    if (!scene.title.empty()) base::print("  {}\n", printable(scene.title));
    base::print("\nContents\n  {} triangles in {} meshes, {} spheres, {} materials, {} lights, {} cameras\n",
                needs.triangles, scene.meshes.size(), scene.spheres.size(), scene.materials.size(),
                scene.lights.size(), scene.cameras.size());
    base::print("  bounds ({:.6g} {:.6g} {:.6g}) to ({:.6g} {:.6g} {:.6g})\n", bounds.lower.x, bounds.lower.y,
                bounds.lower.z, bounds.upper.x, bounds.upper.y, bounds.upper.z);
    for (const CameraDescription& camera : scene.cameras)
        base::print("  camera '{}' from ({:.6g} {:.6g} {:.6g}), fov {:.6g}°{}\n", printable(camera.name),
                    camera.lookFrom.x, camera.lookFrom.y, camera.lookFrom.z, camera.fov,
                    camera.lens ? ", with a lens" : "");
    for (const SettingAssignment& setting : scene.settings)
        base::print("  setting {} = {}\n", printable(setting.key), printable(setting.value));
    base::print("\nRequirements\n");
    for (const Requirement& requirement : needs.list)
        base::print("  {} {:<22} {}\n", requirement.needed ? "needs" : "not: ", requirement.name,
                    printable(requirement.reason));
    base::print("\nLint\n");
    for (const Diagnostic& finding : findings) base::print("  {}\n", toString(finding));
    if (findings.empty()) base::print("  nothing found\n");
}

nlohmann::json infoJson(const Opened& opened) {
    const auto& [scene, needs, bounds, findings] = opened;
    nlohmann::json j = {{"scene", scene.path},
                        {"title", scene.title},
                        {"triangles", needs.triangles},
                        {"spheres", needs.spheres},
                        {"meshes", scene.meshes.size()},
                        {"materials", scene.materials.size()},
                        {"lights", scene.lights.size()},
                        {"cameras", nlohmann::json::array()},
                        {"bounds",
                         {{"lower", {bounds.lower.x, bounds.lower.y, bounds.lower.z}},
                          {"upper", {bounds.upper.x, bounds.upper.y, bounds.upper.z}}}},
                        {"settings", nlohmann::json::object()},
                        {"requirements", nlohmann::json::array()},
                        {"lint", nlohmann::json::array()}};
    for (const CameraDescription& camera : scene.cameras) j["cameras"].push_back(camera.name);
    for (const SettingAssignment& setting : scene.settings) j["settings"][setting.key] = setting.value;
    for (const Requirement& requirement : needs.list)
        j["requirements"].push_back(
            {{"name", requirement.name}, {"needed", requirement.needed}, {"because", requirement.reason}});
    for (const Diagnostic& finding : findings) j["lint"].push_back(diagnosticJson(finding));
    return j;
}

int runInfo(const InfoOptions& options) {
    if (options.list) return listScenes(options.json);
    if (options.scene.empty()) throw UsageError("SCENE is required");
    Opened opened;
    {
        const LoadProgress progress(progressStyle("", false));
        opened.scene = loadScene(options.scene, opened.findings, progress.control());
        opened.bounds = boundsOf(opened.scene, progress.control());
        for (Diagnostic& finding : lint(opened.scene, opened.findings, progress.control()))
            opened.findings.push_back(std::move(finding));
    }
    opened.needs = requirementsOf(opened.scene);
    if (options.json)
        base::writeOutput(base::jsonText(infoJson(opened)));
    else
        printText(opened);
    return kSuccess;
}

}  // namespace

std::function<int()> setUpInfo(OptionList& list) {
    auto options = std::make_shared<InfoOptions>();
    list.add("SCENE", &options->scene, sceneOptionHelp()).suggest(builtinSceneNames);
    list.add("--json", &options->json, "Print JSON");
    list.add("--list", &options->list, "List the built-in scenes");
    return [options] { return runInfo(*options); };
}

}  // namespace rayscope::cli
