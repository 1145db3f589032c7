#include "probe/traversal_log.h"

#include <algorithm>

#include "probe/binary_traversal_recorder.h"
#include "probe/counting_observer.h"
#include "trace/world.h"

namespace rayscope {

namespace {

TraversalLog startLog(const World& world, std::size_t number, const Ray& ray, float time) {
    TraversalLog log;
    log.body = number;
    log.ray = ray;
    if (world.moves) {
        const glm::dvec3 shift =
            static_cast<double>(time) * glm::dvec3(world.bodies[number].geometry->motion);
        log.ray.origin = glm::vec3(glm::dvec3(ray.origin) - shift);
        log.shift = glm::vec3(shift);
    }
    return log;
}

const BinaryTree* treeOf(const World& world, const Body& body) {
    return world.settings.bvh && body.accel ? body.accel->binaryTree() : nullptr;
}

}  // namespace

std::size_t TraversalLog::count(TraversalEvent event) const {
    return static_cast<std::size_t>(std::count_if(
        steps.begin(), steps.end(), [&](const TraversalStep& step) { return step.event == event; }));
}

void advance(TraversalState& state, const TraversalStep& step) {
    const auto takeFromStack = [&] {
        std::erase_if(state.stack,
                      [&](const TraversalState::Waiting& waiting) { return waiting.box == step.number; });
    };
    switch (step.event) {
        case TraversalEvent::Entered:
            takeFromStack();
            state.current = static_cast<int>(step.number);
            break;
        case TraversalEvent::Waits:
            state.stack.push_back({step.number, step.t});
            break;
        case TraversalEvent::Behind:
        case TraversalEvent::Missed:
            takeFromStack();
            break;
        case TraversalEvent::Hit:
            state.bound = step.t;
            state.closest = step.number;
            break;
        case TraversalEvent::NoHit:
            break;
    }
}

TraversalState stateAfter(const TraversalLog& log, std::size_t steps) {
    TraversalState state;
    state.bound = log.ray.tMax;
    for (std::size_t i = 0; i < std::min(steps, log.steps.size()); ++i) advance(state, log.steps[i]);
    return state;
}

std::vector<TraversalLog> recordClosestHit(const World& world, const Ray& ray, float time) {
    std::vector<TraversalLog> logs;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const BinaryTree* tree = treeOf(world, world.bodies[i]);
        if (tree == nullptr) continue;
        TraversalLog log = startLog(world, i, ray, time);
        if (!RayQuery::isTraceable(log.ray)) continue;
        BinaryTraversalRecorder recorder(log, *tree, world.bodies[i].geometry->input);
        closestHit(*tree, world.bodies[i].geometry->input, log.ray, log.hit, recorder);
        logs.push_back(std::move(log));
    }
    return logs;
}

std::vector<TraversalLog> recordAnyHit(const World& world, const Ray& ray, float time) {
    std::vector<TraversalLog> logs;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const BinaryTree* tree = treeOf(world, world.bodies[i]);
        if (tree == nullptr) continue;
        TraversalLog log = startLog(world, i, ray, time);
        if (!RayQuery::isTraceable(log.ray)) continue;
        log.anyHit = true;
        BinaryTraversalRecorder recorder(log, *tree, world.bodies[i].geometry->input);
        Hit hit;
        const bool found = anyHitWatched(*tree, world.bodies[i].geometry->input, log.ray, recorder, hit);
        if (found) log.hit = hit;
        logs.push_back(std::move(log));
        if (found) break;
    }
    return logs;
}

}  // namespace rayscope
