#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/number_list.h"
#include "cli/scene_options.h"
#include "viewer/viewer.h"

namespace rayscope::cli {

namespace {

std::optional<glm::vec3> optionalVector(const std::string& option, const std::string& text) {
    if (text.empty()) return std::nullopt;
    return parseVector(option, text);
}

int runView(const SceneOptions& options) {
    viewer::ViewerOptions viewer;
    viewer.scene = options.scene;
    const glm::ivec2 size = parsePair("--size", options.size, 'x', 1);
    viewer.width = size.x;
    viewer.height = size.y;
    viewer.preset = options.preset;
    viewer.settings = parseAssignments(options);
    viewer.camera = {options.camera, optionalVector("--look-from", options.lookFrom),
                     optionalVector("--look-at", options.lookAt), optionalVector("--up", options.up),
                     options.fov};
    viewer.threads = options.threads;
    return viewer::runViewer(viewer);
}

}  // namespace

std::function<int()> setUpView(OptionList& list) {
    auto options = std::make_shared<SceneOptions>();
    options->scene = viewer::kDefaultScene;
    options->size = "1280x720";
    options->addTo(list, false);
    return [options] { return runView(*options); };
}

}  // namespace rayscope::cli
