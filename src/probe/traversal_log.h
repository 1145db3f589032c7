#pragma once
// The traversal of one tree by one ray, step by step. A log has boxes and primitives only, so that it is the
// same for every layout; each layout has a recorder of its own.
#include <rayscope/ray.h>
#include <rayscope/settings.h>
#include <rayscope/vector.h>
#include <cstdint>
#include <string>
#include <vector>

namespace rayscope::trace {
class World;
}

namespace rayscope::probe {

enum class TraversalEvent {
    Visited,  ///< children or primitives of the node are tested now
    Pushed,   ///< the box was hit, and the node goes onto the stack
    Culled,   ///< the box was hit, but begins behind the closest hit
    Missed,   ///< the ray misses the box
    Hit,      ///< a primitive becomes the closest hit
    NoHit,    ///< a primitive was tested and is missed, or farther than the closest hit
    Filtered  ///< the float test of a block excludes a hit of the primitive
};

/// One step. Distances are in units of the ray's direction.
struct TraversalStep {
    TraversalEvent event = TraversalEvent::Visited;
    /// Of a box: index into TraversalLog::boxes; otherwise of the primitive in its motion group.
    std::uint32_t number = 0;
    float t = 0.0f;      ///< where the ray enters the box or hits the primitive; NaN on a miss
    float bound = 0.0f;  ///< traversal bound before the step
};

/// A box that was tested.
struct TraversalBox {
    std::uint32_t node = 0;  ///< its number in the tree; leaves of the wide layout have numbers of their own
    int parent = -1;         ///< index into TraversalLog::boxes
    bool leaf = false;
    glm::vec3 lower{0.0f}, upper{0.0f};
};

struct TraversalLog {
    std::size_t motionGroup = 0;           ///< of the world
    Ray ray;                               ///< in the rest frame of the motion group
    glm::vec3 shift{0.0f};                 ///< of the motion group from its rest frame at the time of the ray
    bool anyHit = false;                   ///< ends at the first hit, as for shadow rays
    BvhLayout layout = BvhLayout::Binary;  ///< of the tree
    std::vector<TraversalBox> boxes;
    std::vector<TraversalStep> steps;
    Hit hit;  ///< `primitive` counts within the motion group

    std::size_t count(TraversalEvent event) const;
    /// Primitives tested exactly.
    std::size_t tests() const { return count(TraversalEvent::Hit) + count(TraversalEvent::NoHit); }
};

/// The state after a number of steps.
struct TraversalState {
    struct StackEntry {
        std::uint32_t box;
        float t;
    };
    int current = -1;               ///< box of the node visited last; -1 before the first
    std::vector<StackEntry> stack;  ///< the top is last
    float bound = 0.0f;
    std::uint32_t closest = kNoPrimitive;
};
void advance(TraversalState& state, const TraversalStep& step);
TraversalState stateAfter(const TraversalLog& log, std::size_t steps);

/// Records the traversal of World::closestHit in every motion group of the world, at the given time of the
/// shutter. Empty if the BVH is off, or if there is no tree of this layout.
///
/// The wide tree is traversed by the portable kernel. Kernels of other instruction sets round distances to
/// boxes differently, and may visit a box more or less where a ray passes along its side; their hits are the
/// same.
std::vector<TraversalLog> recordClosestHit(const trace::World& world, const Ray& ray, float time,
                                           BvhLayout layout = BvhLayout::Binary);
/// The same for any hit, as for shadow rays; ends at the motion group of the first hit.
std::vector<TraversalLog> recordAnyHit(const trace::World& world, const Ray& ray, float time,
                                       BvhLayout layout = BvhLayout::Binary);

/// "visits node 12".
std::string describe(const TraversalLog& log, const TraversalStep& step);
/// The number of events of each kind, in one line.
std::string summary(const TraversalLog& log);
/// One line per step, with the traversal bound and the stack; and the same as JSON.
std::string toText(const TraversalLog& log);
std::string toJson(const TraversalLog& log);

}  // namespace rayscope::probe
