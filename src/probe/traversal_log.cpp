#include "probe/traversal_log.h"

#include <algorithm>

#include "probe/binary_traversal_recorder.h"
#include "probe/wide_traversal.h"
#include "trace/world.h"

namespace rayscope::probe {

namespace {

TraversalLog startLog(const trace::World& world, std::size_t number, const Ray& ray, float time) {
    TraversalLog log;
    log.motionGroup = number;
    const trace::Geometry& geometry = *world.motionGroups[number].geometry;
    log.ray = geometry.inRestFrame(ray, time);
    log.shift = glm::vec3(geometry.displacement(time));
    return log;
}

/// Records the traversal of one motion group; false if it has no tree of this layout.
bool recordGroup(const trace::MotionGroup& motionGroup, const trace::World& world, TraversalLog& log) {
    if (!world.settings.bvh || !motionGroup.accel || !bvh::RayQuery::isTraceable(log.ray)) return false;
    if (log.layout == BvhLayout::Wide) {
        const bvh::WideTree* wide = motionGroup.accel->wideTree();
        if (wide != nullptr) recordWideTraversal(*wide, log);
        return wide != nullptr;
    }
    const bvh::BinaryTree* tree = motionGroup.accel->binaryTree();
    if (tree == nullptr) return false;
    const AccelInput& input = motionGroup.geometry->input;
    BinaryTraversalRecorder recorder(log, *tree);
    Hit hit;
    const bool found = log.anyHit
                           ? bvh::traverse<bvh::QueryKind::Any>(*tree, input, log.ray, hit, recorder)
                           : bvh::traverse<bvh::QueryKind::Closest>(*tree, input, log.ray, hit, recorder);
    if (found) log.hit = hit;
    return true;
}

std::vector<TraversalLog> record(const trace::World& world, const Ray& ray, float time, BvhLayout layout,
                                 bool anyHit) {
    std::vector<TraversalLog> logs;
    for (std::size_t i = 0; i < world.motionGroups.size(); ++i) {
        TraversalLog log = startLog(world, i, ray, time);
        log.layout = layout;
        log.anyHit = anyHit;
        if (!recordGroup(world.motionGroups[i], world, log)) continue;
        const bool found = log.hit.primitive != kNoPrimitive;
        logs.push_back(std::move(log));
        if (anyHit && found) break;
    }
    return logs;
}

}  // namespace

std::size_t TraversalLog::count(TraversalEvent event) const {
    return static_cast<std::size_t>(std::count_if(
        steps.begin(), steps.end(), [&](const TraversalStep& step) { return step.event == event; }));
}

void advance(TraversalState& state, const TraversalStep& step) {
    const auto removeFromStack = [&] {
        std::erase_if(state.stack,
                      [&](const TraversalState::StackEntry& entry) { return entry.box == step.number; });
    };
    switch (step.event) {
        case TraversalEvent::Visited:
            removeFromStack();
            state.current = static_cast<int>(step.number);
            break;
        case TraversalEvent::Pushed:
            state.stack.push_back({step.number, step.t});
            break;
        case TraversalEvent::Culled:
        case TraversalEvent::Missed:
            removeFromStack();
            break;
        case TraversalEvent::Hit:
            state.bound = step.t;
            state.closest = step.number;
            break;
        case TraversalEvent::NoHit:
        case TraversalEvent::Filtered:
            break;
    }
}

TraversalState stateAfter(const TraversalLog& log, std::size_t steps) {
    TraversalState state;
    state.bound = log.ray.tMax;
    for (std::size_t i = 0; i < std::min(steps, log.steps.size()); ++i) advance(state, log.steps[i]);
    return state;
}

std::vector<TraversalLog> recordClosestHit(const trace::World& world, const Ray& ray, float time,
                                           BvhLayout layout) {
    return record(world, ray, time, layout, false);
}

std::vector<TraversalLog> recordAnyHit(const trace::World& world, const Ray& ray, float time,
                                       BvhLayout layout) {
    return record(world, ray, time, layout, true);
}

}  // namespace rayscope::probe
