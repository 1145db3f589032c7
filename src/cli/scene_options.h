#pragma once
// The options that every command which opens a scene understands.
#include <rayscope/render_session.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

/// Opens the scene, prints its notes to stderr (unless quiet) and applies settings in the order: defaults,
/// scene file, command line. Throws InputError.
RenderRequest openScene(const SceneOptions& options, bool quiet);

/// The command that probes a sample of what these options render, ready to be pasted into a shell.
std::string probeCommand(const SceneOptions& options, glm::ivec2 pixel, int sample);

/// The settings that the command line asks for beside the preset, each checked, and the preset's name. Throws
/// InputError or UsageError.
std::vector<SettingAssignment> parseAssignments(const SceneOptions& options);

/// The settings that differ from the defaults, as a [settings] table for a scene file.
std::string dumpSettings(const Settings& settings);

}  // namespace rayscope::cli
