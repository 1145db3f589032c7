#include "cli/render_stats.h"

#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "trace/world.h"

namespace rayscope::cli {

std::string renderStatsJson(const RenderRequest& request, const RenderStatus& status,
                            const trace::World& world, int threads, double totalSeconds) {
    nlohmann::json settings = nlohmann::json::object();
    for (const std::string_view key : settingKeys())
        settings[std::string(key)] = textOf(request.settings, key);
    nlohmann::json motionGroups = nlohmann::json::array();
    for (const trace::MotionGroup& group : world.motionGroups) {
        nlohmann::json row = {{"triangles", group.geometry->input.triangles.size()},
                              {"spheres", group.geometry->input.spheres.size()}};
        if (group.accel) {
            const AccelSummary& summary = group.accel->summary();
            row["nodes"] = summary.binaryNodes;
            row["levels"] = summary.binaryLevels;
            row["wide_nodes"] = summary.wideNodes;
            row["triangle_blocks"] = summary.triangleBlocks;
            row["bytes"] = group.accel->bytes();
            row["dropped_primitives"] = summary.droppedPrimitives;
        }
        motionGroups.push_back(row);
    }
    const double seconds = status.elapsedSeconds;
    const nlohmann::json stats = {
        {"version", RAYSCOPE_VERSION},
        {"scene", request.scene->path},
        {"width", request.width},
        {"height", request.height},
        {"seed", request.seed},
        {"threads", threads},
        {"samples", status.samples},
        {"rays", status.rays},
        {"non_finite_samples", status.nonFiniteSamples},
        {"compile_s", status.compileSeconds},
        {"build_s", status.buildSeconds},
        {"render_s", seconds},
        {"total_s", totalSeconds},
        {"mrays_per_s", seconds > 0.0 ? static_cast<double>(status.rays) * 1e-6 / seconds : 0.0},
        {"bodies", motionGroups},
        {"settings", settings}};
    return base::jsonText(stats);
}

}  // namespace rayscope::cli
