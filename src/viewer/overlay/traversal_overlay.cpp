#include "viewer/overlay/traversal_overlay.h"

#include <algorithm>

#include "viewer/overlay/bvh_overlay.h"
#include "viewer/overlay/palette.h"

namespace rayscope::viewer {

namespace {

bool isTest(probe::TraversalEvent event) {
    return event == probe::TraversalEvent::Hit || event == probe::TraversalEvent::NoHit ||
           event == probe::TraversalEvent::Filtered;
}

/// The latest event of a box within the shown steps.
struct BoxState {
    bool hasEvent = false;
    probe::TraversalEvent last = probe::TraversalEvent::Missed;
};

std::vector<BoxState> boxStates(const probe::TraversalLog& log, std::size_t steps) {
    std::vector<BoxState> states(log.boxes.size());
    for (std::size_t i = 0; i < steps; ++i)
        if (!isTest(log.steps[i].event)) states[log.steps[i].number] = {true, log.steps[i].event};
    return states;
}

}  // namespace

std::size_t shownSteps(const probe::TraversalLog& log, const TraversalOverlayOptions& options) {
    if (!options.stepping) return log.steps.size();
    return std::min(static_cast<std::size_t>(std::max(options.step, 0)), log.steps.size());
}

OverlayBoxes traversalBoxes(const probe::TraversalLog& log, const TraversalOverlayOptions& options) {
    OverlayBoxes boxes;
    if (!options.shown) return boxes;
    const std::size_t steps = shownSteps(log, options);
    const std::vector<BoxState> states = boxStates(log, steps);
    const auto add = [&](std::size_t i, glm::vec4 color, LineStyle style, float width) {
        boxes.push_back(
            {log.boxes[i].lower + log.shift, log.boxes[i].upper + log.shift, color, style, width});
    };
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (!states[i].hasEvent) continue;
        switch (states[i].last) {
            case probe::TraversalEvent::Missed:
                if (options.missed) add(i, palette::kMissedBox, LineStyle::Dotted, 1.0f);
                break;
            case probe::TraversalEvent::Culled:
                if (options.culled) add(i, palette::kCulledBox, LineStyle::Dashed, 1.5f);
                break;
            case probe::TraversalEvent::Pushed:
                add(i, palette::kPushedBox, LineStyle::Dashed, 1.5f);
                break;
            default:
                add(i, palette::kVisitedBox, LineStyle::Solid, 1.3f);
        }
    }
    const int current = probe::stateAfter(log, steps).current;
    if (options.stepping && current >= 0)
        add(static_cast<std::size_t>(current), palette::kVisitedBox, LineStyle::Solid, 3.5f);
    return boxes;
}

OverlayLines traversalLines(const probe::TraversalLog& log, const AccelInput& input,
                            const TraversalOverlayOptions& options, float sceneSize) {
    OverlayLines lines;
    if (!options.shown) return lines;
    const std::size_t steps = shownSteps(log, options);
    const probe::TraversalState state = probe::stateAfter(log, steps);
    const auto outline = [&](std::uint32_t primitive, glm::vec4 color, float width) {
        const std::uint32_t one[] = {primitive};
        for (OverlayLine line : primitiveLines(input, one, color, width)) {
            line.from += log.shift;
            line.to += log.shift;
            lines.push_back(line);
        }
    };
    if (options.stepping && steps > 0 && isTest(log.steps[steps - 1].event))
        outline(log.steps[steps - 1].number, palette::kPushedBox, 2.5f);
    if (state.closest != kNoPrimitive) outline(state.closest, palette::kHitPrimitive, 4.0f);
    if (options.stepping) {
        const float speed = glm::length(log.ray.direction);
        const glm::vec3 origin = log.ray.origin + log.shift;
        const glm::vec3 middle =
            log.boxes.empty() ? origin : 0.5f * (log.boxes[0].lower + log.boxes[0].upper);
        const float reach = glm::distance(origin, middle) + sceneSize;
        const float end = speed > 0.0f ? std::min(state.bound, reach / speed) : 0.0f;
        lines.push_back({origin + log.ray.tMin * log.ray.direction, origin + end * log.ray.direction,
                         palette::kVisitedBox, LineStyle::Solid, 3.5f});
    }
    return lines;
}

}  // namespace rayscope::viewer
