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
    {"bench", "Measure build time, rays per second and memory, compared with Embree where it is installed",
     setUpBench},
    {"cast", "Trace a file of rays", setUpCast},
    {"trade",
     "Measure rendering time against error on this scene, parameter by parameter, and recommend settings for "
     "several time budgets",
     setUpTrade},
    {"lab", "Test numerical robustness: many scales and offsets, compared with exact arithmetic", setUpLab},
    {"compare", "Measure the error of an image against a reference image", setUpCompare},
    {"settings", "List every setting: name, meaning, unit, range, default", setUpSettings},
};

}  // namespace

std::span<const Command> commandTable() { return kCommands; }

}  // namespace rayscope::cli
