#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/scene_options.h"
#include "viewer/viewer.h"

namespace rayscope::cli {

namespace {

int runView(const SceneOptions& options) {
    viewer::ViewerOptions viewer;
    viewer.scene = options.scene;
    viewer.overrides = overridesOf(options);
    viewer.threads = options.threads;
    return viewer::runViewer(viewer);
}

}  // namespace

std::function<int()> setUpView(OptionList& list) {
    auto options = std::make_shared<SceneOptions>();
    options->scene = viewer::kDefaultScene;
    options->size = {1280, 720};
    options->addTo(list, false);
    return [options] { return runView(*options); };
}

}  // namespace rayscope::cli
