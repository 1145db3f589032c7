#pragma once
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace rayscope::viewer {

/// How much a frame may draw. A picture that stands still is drawn once and kept, so it may take its time;
/// one that moves has to keep up with the hand, which takes restraint where OpenGL runs on the processor.
struct DrawingBudget {
    std::size_t triangles = std::numeric_limits<std::size_t>::max();  ///< of all meshes and spheres
    std::size_t boxes = 20000;                                        ///< that are drawn whole
    double linePixels = std::numeric_limits<double>::infinity();      ///< see drawingCost()
    /// More lines than this are painted, one pixel wide, instead of drawn.
    std::size_t maxWideLines = std::numeric_limits<std::size_t>::max();
    int divisor = 1;  ///< pixels of the view per pixel that is drawn, in both directions

    bool operator==(const DrawingBudget&) const = default;
};

/// Whether an OpenGL renderer of this name (GL_RENDERER) draws on the processor.
bool isSoftwareRenderer(std::string_view name);

DrawingBudget drawingBudget(bool software, bool moving);

/// What a frame drew of what there is.
struct DrawnCounts {
    std::size_t triangles = 0, trianglesDrawn = 0;
    std::size_t boxes = 0, boxesDrawn = 0;  ///< large enough to be drawn whole, and drawn so
    std::size_t lines = 0, linesDrawn = 0;  ///< of rays

    int divisor = 1;  ///< see DrawingBudget

    bool operator==(const DrawnCounts&) const = default;
};

/// What the picture lacks, for those who look at it: "2000 of 10240 lines, …"; empty if it lacks nothing.
std::string drawnText(const DrawnCounts& counts);

}  // namespace rayscope::viewer
