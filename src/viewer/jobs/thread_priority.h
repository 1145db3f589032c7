#pragma once

namespace rayscope::viewer {

/// Lowers the priority of the calling thread, so that it runs in the time that the window's thread and the
/// threads of a software OpenGL driver leave. Without effect where threads have no priorities of their own.
void lowerThreadPriority();

}  // namespace rayscope::viewer
