#pragma once
// The interactive window. The only entry point that the command line needs.
#include <rayscope/scene.h>
#include <optional>
#include <string>
#include <vector>

namespace rayscope::viewer {

/// The scene that opens when none is named.
inline constexpr const char* kDefaultScene = "builtin:cornell";

/// What the command line says about the camera; what is absent stays as the scene has it.
struct CameraOverrides {
    std::string name;  ///< of a camera of the scene; empty: the first
    std::optional<glm::vec3> lookFrom, lookAt, up;
    std::optional<float> fov;  ///< vertical, degrees
};

struct ViewerOptions {
    std::string scene = kDefaultScene;        ///< what loadScene() takes
    int width = 1280, height = 720;           ///< of the window, in screen coordinates
    std::string preset;                       ///< applied after the settings of the scene; empty: none
    std::vector<SettingAssignment> settings;  ///< applied last
    CameraOverrides camera;
    int threads = 0;  ///< tracing threads; 0 leaves one core to the window
};

/// Opens the window and returns when it is closed: 0. Where a display or OpenGL 3.3 is missing it says so in
/// one message on stderr and returns 2; a scene that cannot be loaded is shown in the window, except the
/// first, which ends the program like any other wrong input (2).
int runViewer(const ViewerOptions& options);

}  // namespace rayscope::viewer
