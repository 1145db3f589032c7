#pragma once
// The options of every command that opens a scene.
#include <rayscope/open_request.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/progress.h"

namespace rayscope::cli {

class OptionList;

struct SceneOptions {
    std::string scene;
    std::string size = "800x800";
    std::string camera;
    std::string lookFrom, lookAt, up;
    std::optional<float> fov;
    std::optional<int> spp;
    std::string preset;
    std::uint64_t seed = 0;
    int threads = 0;
    std::vector<std::string> assignments;  ///< KEY=VALUE

    void addTo(OptionList& list, bool sceneRequired);
    /// Only the scene, threads and settings.
    void addSceneTo(OptionList& list, bool sceneRequired);
};

/// What SCENE may be, for --help.
std::string sceneOptionHelp();

/// The options in the form of the library. Throws InputError or UsageError.
RequestOverrides overridesOf(const SceneOptions& options);

/// Opens the scene with these options and prints its notes to stderr, unless quiet. Shows the progress of a
/// load that takes long. Throws InputError or UsageError, and Stopped at Ctrl+C.
RenderRequest openScene(const SceneOptions& options, bool quiet, ProgressStyle style);

/// The settings that differ from the defaults, as a [settings] table for a scene file.
std::string dumpSettings(const Settings& settings);

}  // namespace rayscope::cli
