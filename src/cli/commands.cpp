#include "cli/commands.h"

#include <memory>

#include "cli/command_line.h"
#include "cli/memory_option.h"

namespace rayscope::cli {

namespace {

/// The options of a command and --memory-limit, for commands that allocate by their input.
template <CommandSetUp* setUp, bool opensWindow = false>
std::function<int()> limited(OptionList& list) {
    std::function<int()> run = setUp(list);
    auto memory = std::make_shared<MemoryOption>();
    memory->addTo(list);
    return [run = std::move(run), memory = std::move(memory), &list] {
        memory->apply(list, opensWindow);
        return run();
    };
}

constexpr Command kCommands[] = {
#ifdef RAYSCOPE_VIEWER
    {"view", "Open the window (the default command)", limited<setUpView, true>},
#endif
    {"render", "Render a scene to an image file", limited<setUpRender>},
    {"merge", "Join the parts of an image that were rendered separately", limited<setUpMerge>},
    {"probe", "Print the ray tree of a pixel, its BVH traversals and a diagnosis", limited<setUpProbe>},
    {"info", "Print the contents, the requirements and the lint findings of a scene", limited<setUpInfo>},
    {"bench", "Measure build time, rays per second and memory, compared with Embree where it is installed",
     limited<setUpBench>},
    {"cast", "Trace a file of rays", limited<setUpCast>},
    {"trade",
     "Measure rendering time against error on this scene, parameter by parameter, and recommend settings for "
     "several time budgets",
     limited<setUpTrade>},
    {"lab", "Test numerical robustness: many scales and offsets, compared with exact arithmetic",
     limited<setUpLab>},
    {"compare", "Measure the error of an image against a reference image", limited<setUpCompare>},
    {"settings", "List every setting: name, meaning, unit, range, default", setUpSettings},
    {"fetch", "Make the mesh of a built-in scene that is too large to come with the program", setUpFetch},
    {"manual", "Print the manual page", setUpManual},
    {"completions", "Print the completions of a shell", setUpCompletions},
};

}  // namespace

std::span<const Command> commandTable() { return kCommands; }

}  // namespace rayscope::cli
