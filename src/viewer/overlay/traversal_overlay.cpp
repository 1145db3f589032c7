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

/// What became of a box in the end, or as far as the steps go.
struct Fate {
    bool seen = false;
    probe::TraversalEvent last = probe::TraversalEvent::Missed;
};

std::vector<Fate> fatesOf(const probe::TraversalLog& log, std::size_t steps) {
    std::vector<Fate> fates(log.boxes.size());
    for (std::size_t i = 0; i < steps; ++i)
        if (!isTest(log.steps[i].event)) fates[log.steps[i].number] = {true, log.steps[i].event};
    return fates;
}

}  // namespace

std::size_t shownSteps(const probe::TraversalLog& log, const TraversalOverlayOptions& choice) {
    if (!choice.stepping) return log.steps.size();
    return std::min(static_cast<std::size_t>(std::max(choice.step, 0)), log.steps.size());
}

OverlayBoxes traversalBoxes(const probe::TraversalLog& log, const TraversalOverlayOptions& choice) {
    OverlayBoxes boxes;
    if (!choice.shown) return boxes;
    const std::size_t steps = shownSteps(log, choice);
    const std::vector<Fate> fates = fatesOf(log, steps);
    const auto add = [&](std::size_t i, glm::vec4 color, LineStyle style, float width) {
        boxes.push_back(
            {log.boxes[i].lower + log.shift, log.boxes[i].upper + log.shift, color, style, width});
    };
    for (std::size_t i = 0; i < fates.size(); ++i) {
        if (!fates[i].seen) continue;
        switch (fates[i].last) {
            case probe::TraversalEvent::Missed:
                if (choice.missed) add(i, palette::kMissedBox, LineStyle::Dotted, 1.0f);
                break;
            case probe::TraversalEvent::Culled:
                if (choice.culled) add(i, palette::kCulledBox, LineStyle::Dashed, 1.5f);
                break;
            case probe::TraversalEvent::Pushed:
                add(i, palette::kPushedBox, LineStyle::Dashed, 1.5f);
                break;
            default:
                add(i, palette::kVisitedBox, LineStyle::Solid, 1.3f);
        }
    }
    const int current = probe::stateAfter(log, steps).current;
    if (choice.stepping && current >= 0)
        add(static_cast<std::size_t>(current), palette::kVisitedBox, LineStyle::Solid, 3.5f);
    return boxes;
}

OverlayLines traversalLines(const probe::TraversalLog& log, const AccelInput& input,
                            const TraversalOverlayOptions& choice, float sceneSize) {
    OverlayLines lines;
    if (!choice.shown) return lines;
    const std::size_t steps = shownSteps(log, choice);
    const probe::TraversalState state = probe::stateAfter(log, steps);
    const auto outline = [&](std::uint32_t primitive, glm::vec4 color, float width) {
        const std::uint32_t one[] = {primitive};
        for (OverlayLine line : primitiveLines(input, one, color, width)) {
            line.from += log.shift;
            line.to += log.shift;
            lines.push_back(line);
        }
    };
    if (choice.stepping && steps > 0 && isTest(log.steps[steps - 1].event))
        outline(log.steps[steps - 1].number, palette::kPushedBox, 2.5f);
    if (state.closest != kNoPrimitive) outline(state.closest, palette::kHitPrimitive, 4.0f);
    if (choice.stepping) {
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
