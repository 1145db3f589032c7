#include "probe/names.h"

#include <fmt/format.h>
#include <rayscope/probe.h>

#include "trace/world.h"

namespace rayscope {

std::string_view nameOf(RayKind kind) {
    constexpr std::string_view names[] = {"camera", "reflection", "glossy", "transparent"};
    return names[static_cast<int>(kind)];
}

std::string_view nameOf(RayEnd end) {
    constexpr std::string_view names[] = {"missed",      "absorbed",      "reflected", "transmitted",
                                          "depth limit", "below surface", "vanished"};
    return names[static_cast<int>(end)];
}

std::string_view nameOf(Visibility visibility) {
    constexpr std::string_view names[] = {"visible", "occluded", "attenuated", "facing away"};
    return names[static_cast<int>(visibility)];
}

std::string objectName(const trace::World& world, int object) {
    const SceneDescription& scene = *world.description;
    const auto index = static_cast<std::size_t>(object);
    if (index < scene.meshes.size()) return fmt::format("mesh {} '{}'", index, scene.meshes[index].name);
    const std::size_t sphere = index - scene.meshes.size();
    return fmt::format("sphere {} '{}'", sphere, scene.spheres[sphere].name);
}

}  // namespace rayscope

namespace rayscope::probe {

std::string_view nameOf(TraversalEvent event) {
    constexpr std::string_view names[] = {"visits", "pushes", "culls", "misses", "hits", "tests", "filters"};
    return names[static_cast<int>(event)];
}

}  // namespace rayscope::probe
