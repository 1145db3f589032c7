#include <fmt/format.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "probe/names.h"
#include "probe/traversal_log.h"

namespace rayscope::probe {

namespace {

bool isBoxEvent(TraversalEvent event) {
    return event != TraversalEvent::Hit && event != TraversalEvent::NoHit &&
           event != TraversalEvent::Filtered;
}

std::string stackText(const TraversalLog& log, const TraversalState& state) {
    std::string text;
    for (auto entry = state.stack.rbegin(); entry != state.stack.rend(); ++entry)
        text += fmt::format(" {}@{:.6g}", log.boxes[entry->box].node, entry->t);
    return text.empty() ? " -" : text;
}

std::string distanceText(const TraversalStep& step) {
    return std::isnan(step.t) ? "-" : fmt::format("{:.9g}", step.t);
}

}  // namespace

std::string describe(const TraversalLog& log, const TraversalStep& step) {
    if (!isBoxEvent(step.event)) return fmt::format("{} primitive {}", nameOf(step.event), step.number);
    const TraversalBox& box = log.boxes[step.number];
    return fmt::format("{} {} {}", nameOf(step.event), box.leaf ? "leaf" : "node", box.node);
}

std::string summary(const TraversalLog& log) {
    std::string text = fmt::format("{} nodes visited, {} culled, {} missed, {} primitives tested",
                                   log.count(TraversalEvent::Visited), log.count(TraversalEvent::Culled),
                                   log.count(TraversalEvent::Missed), log.tests());
    if (log.layout == BvhLayout::Binary) return text;
    return text + fmt::format(", {} filtered", log.count(TraversalEvent::Filtered));
}

std::string toText(const TraversalLog& log) {
    std::string out = fmt::format("{} hit in the {} of motion group {}: {}\n", log.anyHit ? "any" : "closest",
                                  log.layout == BvhLayout::Wide ? "wide tree" : "binary tree",
                                  log.motionGroup, summary(log));
    out += fmt::format("  {:>5}  {:<26} {:>12}  {:>12}  stack, next first (node@entry)\n", "step", "event",
                       "t", "bound");
    TraversalState state = stateAfter(log, 0);
    for (std::size_t i = 0; i < log.steps.size(); ++i) {
        const TraversalStep& step = log.steps[i];
        advance(state, step);
        out += fmt::format("  {:>5}  {:<26} {:>12}  {:>14.9g} {}\n", i + 1, describe(log, step),
                           distanceText(step), state.bound, stackText(log, state));
    }
    return out + (log.hit.primitive == kNoPrimitive
                      ? std::string("  nothing hit\n")
                      : fmt::format("  hit: primitive {} at t {:.9g}\n", log.hit.primitive, log.hit.t));
}

std::string toJson(const TraversalLog& log) {
    nlohmann::json j = {{"body", log.motionGroup},
                        {"search", log.anyHit ? "any" : "closest"},
                        {"layout", log.layout == BvhLayout::Wide ? "wide" : "binary"},
                        {"boxes", nlohmann::json::array()},
                        {"steps", nlohmann::json::array()},
                        {"hit", nullptr}};
    for (const TraversalBox& box : log.boxes)
        j["boxes"].push_back({{"node", box.node},
                              {"parent", box.parent},
                              {"leaf", box.leaf},
                              {"lower", {box.lower.x, box.lower.y, box.lower.z}},
                              {"upper", {box.upper.x, box.upper.y, box.upper.z}}});
    TraversalState state = stateAfter(log, 0);
    for (const TraversalStep& step : log.steps) {
        advance(state, step);
        nlohmann::json item = {{"event", nameOf(step.event)},
                               {isBoxEvent(step.event) ? "box" : "primitive", step.number},
                               {"t", step.t},
                               {"closest_so_far", state.bound},
                               {"stack", nlohmann::json::array()}};
        for (auto entry = state.stack.rbegin(); entry != state.stack.rend(); ++entry)
            item["stack"].push_back({{"box", entry->box}, {"t", entry->t}});
        j["steps"].push_back(std::move(item));
    }
    if (log.hit.primitive != kNoPrimitive)
        j["hit"] = {{"primitive", log.hit.primitive}, {"t", log.hit.t}, {"u", log.hit.u}, {"v", log.hit.v}};
    return base::jsonText(j);
}

}  // namespace rayscope::probe
