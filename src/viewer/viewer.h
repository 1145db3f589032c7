#pragma once
// The interactive window: the entry point for the command line.
#include <rayscope/open_request.h>
#include <string>

namespace rayscope::viewer {

/// The scene that opens when none is named.
inline constexpr const char* kDefaultScene = "builtin:cornell";

struct ViewerOptions {
    std::string scene = kDefaultScene;  ///< what loadScene() takes
    RequestOverrides overrides;         ///< its size is that of the window, in screen coordinates
    int threads = 0;                    ///< tracing threads; 0: all cores, but one while something moves
};

/// Opens the window and returns when it is closed: 0. A scene that takes long to load appears when it is
/// loaded. If it cannot be loaded, or if there is no display or no OpenGL 3.3, prints one message to stderr
/// and returns 2; scenes opened later report their errors in the window.
int runViewer(const ViewerOptions& options);

}  // namespace rayscope::viewer
