#pragma once
// The options of every command that opens a scene.
#include <rayscope/open_request.h>
#include <rayscope/vector.h>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/progress.h"

namespace rayscope::cli {

class OptionList;

struct SceneOptions {
    std::string scene;
    glm::ivec2 size{800, 800};
    std::string camera;
    std::optional<glm::vec3> lookFrom, lookAt, up;
    std::optional<float> fov;
    std::optional<glm::vec3> lens;  ///< f-number, focal length, focus distance
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
/// The built-in scenes as SCENE names them, such as "builtin:cornell".
std::vector<std::string> builtinSceneNames();
// Options that several commands have, with the same names and ranges everywhere.
void addThreadsTo(OptionList& list, int& threads);
void addSettingsTo(OptionList& list, std::vector<std::string>& assignments);
void addProgressTo(OptionList& list, std::string& progress);

/// The options in the form of the library. Throws InputError or UsageError.
RequestOverrides overridesOf(const SceneOptions& options);

/// Opens the scene with these options and prints its notes to stderr, unless quiet. Shows the progress of a
/// load that takes long. Throws InputError or UsageError, and Stopped at Ctrl+C.
RenderRequest openScene(const SceneOptions& options, bool quiet, ProgressStyle style);

/// The settings that differ from the defaults, as a [settings] table for a scene file.
std::string dumpSettings(const Settings& settings);

}  // namespace rayscope::cli
