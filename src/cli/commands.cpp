#include "cli/commands.h"

#include "cli/command_line.h"

namespace rayscope::cli {

namespace {

constexpr Command kCommands[] = {
#ifdef RAYSCOPE_VIEWER
    {"view", "Open the window (the default command)", setUpView},
#endif
    {"render", "Render a scene to an image file", setUpRender},
    {"probe", "Print the ray tree of a pixel, its BVH traversals and a diagnosis", setUpProbe},
    {"info", "Print the contents, the requirements and the lint findings of a scene", setUpInfo},
    {"bench", "Measure build time, rays per second and memory, beside Embree where it is installed",
     setUpBench},
    {"cast", "Trace the rays of a file and write their hits", setUpCast},
    {"trade", "Study speed against accuracy: vary each setting on this scene and recommend combinations",
     setUpTrade},
    {"lab", "Test numerical robustness: compare hits at many scales and offsets with exact arithmetic",
     setUpLab},
    {"compare", "Measure the error of an image against a reference image", setUpCompare},
    {"settings", "List every setting: name, meaning, unit, range, default", setUpSettings},
};

}  // namespace

std::span<const Command> commandTable() { return kCommands; }

}  // namespace rayscope::cli
