#pragma once
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace rayscope::viewer {

/// Limits of what a frame draws. A still picture is drawn once and kept, so it has none; while the camera
/// moves they keep the frame rate up where OpenGL runs on the CPU.
struct DrawingBudget {
    std::size_t triangles = std::numeric_limits<std::size_t>::max();  ///< of all meshes and spheres
    std::size_t boxes = 20000;                                        ///< drawn with all edges
    double linePixels = std::numeric_limits<double>::infinity();      ///< see drawingCost()
    /// More lines than this are drawn by paintLines(), one pixel wide.
    std::size_t maxWideLines = std::numeric_limits<std::size_t>::max();
    int divisor = 1;  ///< pixels of the view per pixel of the framebuffer, in both directions

    bool operator==(const DrawingBudget&) const = default;
};

/// Whether the OpenGL renderer of this name (GL_RENDERER) runs on the CPU.
bool isSoftwareRenderer(std::string_view name);

DrawingBudget drawingBudget(bool software, bool moving);

/// How much a frame drew, and how much there is.
struct DrawnCounts {
    std::size_t triangles = 0, trianglesDrawn = 0;
    std::size_t boxes = 0, boxesDrawn = 0;  ///< large enough for all edges, and drawn with them
    std::size_t lines = 0, linesDrawn = 0;  ///< of rays

    int divisor = 1;  ///< see DrawingBudget

    bool operator==(const DrawnCounts&) const = default;
};

/// What the frame left out, as a text: "2000 of 10240 lines, …"; empty if nothing.
std::string drawnText(const DrawnCounts& counts);

}  // namespace rayscope::viewer
